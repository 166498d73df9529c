// Whether every query of two meshes refuses them.
#pragma once

#include "flashbvh/clearance.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/solid.hpp"

namespace flashbvh::test {

/// Whether each query of A and B, at rest, ends with `cell_mismatch` and answers yes.
inline bool are_refused(const Mesh& a, const Mesh& b) {
  const Pose still = Pose::translated(0, 0, 0);
  const BodyMotion rest = BodyMotion::between(still, still);
  const auto is_refused = [](const Answer& answer) {
    return answer.status == Status::cell_mismatch && answer.yes;
  };
  Triangle of[2];
  return PairQuery(a, b, still).status() == Status::cell_mismatch &&
         is_refused(intersects(a, b, still)) && is_refused(closer_than(a, b, still, {0})) &&
         distance(a, b, still).status == Status::cell_mismatch &&
         is_refused(solids_intersect(a, b, still)) && is_refused(one_is_inside(a, b, still)) &&
         FirstContact(a, b, rest).run(UINT32_MAX).status == Status::cell_mismatch &&
         !transform_pair(a, b, still, {a.triangle_ids[0], b.triangle_ids[0]}, of[0], of[1]);
}

}  // namespace flashbvh::test
