// The analysed and measured code of a guard: one period.
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

// In a separate file, so that they are neither inlined nor specialised. `period`: a bound::Period.
extern "C" {
void bound_period(void* period);
void bound_done();  ///< ends each of these; the analysis ignores later code
}
