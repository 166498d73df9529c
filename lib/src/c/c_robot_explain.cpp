// The C interface to Guard::explain(), in a file of its own: it is linked only if it is called.
#include "flashbvh/robot.h"
#include "flashbvh/robot/guard.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_guard_explain(flashbvh_guard* guard, uint16_t pair, int32_t* changes,
                                       flashbvh_pair_detail* detail) {
  const PairDetail known = reinterpret_cast<Guard*>(guard)->explain(pair, changes);
  *detail = {known.nearest, known.triangles, {known.witness.a, known.witness.b}, known.variable};
  return c_status(known.status);
}
