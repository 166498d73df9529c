// The setups of one firmware image, as `flashbvh bench --firmware` writes them.
#pragma once

#include <stdint.h>

namespace benchmark {

struct Head {
  uint32_t number;  ///< in the order of the tables, from 0
  uint32_t table;   ///< the paper's number
  const char* name;
};

/// One object's images in both layouts, with levels.
struct Object {
  const uint32_t* pre;
  const uint32_t* post;
};

struct Setup {
  Head head;
  Object a;
  Object b;
  int32_t translation[3];  ///< of B in A's frame, in cells
};

/// Each ends with an element whose name is null.
extern const Setup kSetups[];
extern const Head kLeftOut[];  ///< the setups that are in no image

}  // namespace benchmark
