// The C interface to solids.
#include "flashbvh/solid.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_POINT_INSIDE == static_cast<int>(PointSide::inside), "one list of sides");

flashbvh_status flashbvh_inside(const flashbvh_mesh* mesh, const flashbvh_point* point,
                                flashbvh_point_side* side) {
  const PointAnswer answer = inside(object_in(mesh), *point);
  *side = static_cast<flashbvh_point_side>(answer.side);
  return c_status(answer.status);
}

flashbvh_status flashbvh_one_is_inside(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                       const flashbvh_pose* pose, bool* yes) {
  return put_answer(one_is_inside(object_in(a), object_in(b), object_in(pose)), yes);
}
