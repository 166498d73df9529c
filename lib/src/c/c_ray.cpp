// The C interface to rays.
#include "flashbvh/ray.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_MAX_RAY_COORDINATE == kMaxRayCoordinate, "one range of rays");

flashbvh_status flashbvh_nearest_hit(const flashbvh_mesh* mesh, const flashbvh_segment* segment,
                                     uint16_t hint, bool* yes, flashbvh_hit* hit) {
  const RayAnswer<uint16_t> answer = nearest_hit(object_in(mesh), *segment, hint);
  const RayHit<uint16_t>& found = answer.hit;
  *hit = {found.along.above, found.along.below, found.triangle, found.slot, found.side};
  return put_answer(answer, yes);
}

uint32_t flashbvh_distance_along(const flashbvh_segment* segment, const flashbvh_hit* hit) {
  return distance_along(*segment, {hit->above, hit->below});
}
