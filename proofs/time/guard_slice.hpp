// What is analysed and measured of a guard: a period of it.
#pragma once

#include <stdint.h>

#include "flashbvh/robot/guard.hpp"

namespace bound {

struct Period {
  flashbvh::Guard* guard;
  const flashbvh::JointCoordinate* values;
  uint32_t work;
  flashbvh::GuardAnswer answer;
};

}  // namespace bound

// In a file of their own, to be neither inlined nor made for one use. `period`: a bound::Period.
extern "C" {
void bound_period(void* period);
void bound_done();  ///< after each of these: what follows is not looked at
}
