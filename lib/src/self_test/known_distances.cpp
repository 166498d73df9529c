// Known-answer test of distances.
#include "flashbvh/clearance.hpp"
#include "flashbvh/self_test.hpp"
#include "known_answers.hpp"

namespace flashbvh {
namespace detail {

/// Measures each distance, then tests it at its upper bound and just below its lower bound.
uint32_t known_distances_digest() {
  const Mesh mesh = known_mesh();
  AnswerDigest digest;
  for_each_known_pose(3, [&](const Pose& pose) {
    const Clearance<uint16_t> known = distance(mesh, mesh, pose);
    digest.add(static_cast<uint32_t>(known.status));
    digest.add(known.lower);
    digest.add(known.upper);
    digest.add(known.triangles.a, known.triangles.b);
    digest.add(static_cast<uint32_t>(known.point_a.x));
    digest.add(static_cast<uint32_t>(known.point_b.y));
    digest.add(static_cast<uint32_t>(known.direction.z));
    const bool is_within = closer_than(mesh, mesh, pose, {known.upper}).yes;
    const bool is_nearer = known.lower != 0 && closer_than(mesh, mesh, pose, {known.lower - 1}).yes;
    digest.add(is_within ? 1 : 0, is_nearer ? 1 : 0);
  });
  return digest.value();
}

}  // namespace detail

Status test_known_distances() {
  return detail::passed(detail::known_distances_digest(), 0xB647CCF5u);
}

}  // namespace flashbvh
