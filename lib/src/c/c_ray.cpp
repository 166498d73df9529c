// The C interface to rays.
#include "flashbvh/ray.h"
#include "flashbvh/ray.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_MAX_RAY_COORDINATE == kMaxRayCoordinate, "one range of rays");

namespace {

flashbvh_hit c_hit(const RayHit<uint16_t>& hit) {
  return {hit.along.above, hit.along.below, hit.triangle, hit.slot, hit.side};
}

flashbvh_status put_hit(const RayAnswer<uint16_t>& answer, bool* yes, flashbvh_hit* hit) {
  *hit = c_hit(answer.hit);
  return put_answer(answer, yes);
}

}  // namespace

flashbvh_status flashbvh_nearest_hit(const flashbvh_mesh* mesh, const flashbvh_segment* segment,
                                     uint16_t hint, bool* yes, flashbvh_hit* hit) {
  return put_hit(nearest_hit(object_in(mesh), *segment, hint), yes, hit);
}

flashbvh_status flashbvh_any_hit(const flashbvh_mesh* mesh, const flashbvh_segment* segment,
                                 bool* yes, flashbvh_hit* hit) {
  return put_hit(any_hit(object_in(mesh), *segment), yes, hit);
}

flashbvh_status flashbvh_for_each_hit(const flashbvh_mesh* mesh, const flashbvh_segment* segment,
                                      flashbvh_hit_visitor* visit, void* context) {
  const auto visit_it = [visit, context](const RayHit<uint16_t>& hit) {
    const flashbvh_hit found = c_hit(hit);
    return visit(&found, context);
  };
  return c_status(for_each_hit(object_in(mesh), *segment, visit_it));
}

flashbvh_status flashbvh_signed_crossings(const flashbvh_mesh* mesh,
                                          const flashbvh_segment* segment, int32_t* outwards) {
  const CrossingCount count = signed_crossings(object_in(mesh), *segment);
  *outwards = count.outwards;
  return c_status(count.status);
}

void flashbvh_point_along(const flashbvh_segment* segment, const flashbvh_hit* hit,
                          flashbvh_fine_point* point) {
  *point = point_along(*segment, {hit->above, hit->below});
}

uint32_t flashbvh_distance_along(const flashbvh_segment* segment, const flashbvh_hit* hit) {
  return distance_along(*segment, {hit->above, hit->below});
}
