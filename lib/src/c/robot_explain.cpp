// The C interface to what a guard says of a pair: apart, as it is linked only if it is called.
#include "flashbvh/robot/guard.hpp"
#include "robot_objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_guard_explain(flashbvh_guard* guard, uint16_t pair, int32_t* changes,
                                       flashbvh_pair_detail* detail) {
  const PairDetail known = reinterpret_cast<Guard*>(guard->opaque.bytes)->explain(pair, changes);
  const NearestPoints& n = known.nearest;
  *detail = {{{n.point_a.x, n.point_a.y, n.point_a.z},
              {n.point_b.x, n.point_b.y, n.point_b.z},
              {n.direction.x, n.direction.y, n.direction.z},
              n.lower,
              n.upper},
             {known.triangles.a, known.triangles.b},
             {known.witness.a, known.witness.b},
             known.variable};
  return c_status(known.status);
}
