// The known answers are right, by brute force over all pairs of triangles.
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "self_test/known_answers.hpp"
#include "support/all_distances.hpp"
#include "support/record.hpp"
#include "support/test.hpp"

namespace {

const Mesh kMesh = detail::known_mesh();

}  // namespace

TEST_CASE("the known mesh is what open_image() accepts, closed, and a tree of several levels") {
  Mesh mesh{};
  REQUIRE(open_image(detail::kKnownMesh, sizeof detail::kKnownMesh, mesh) == Status::done);
  CHECK(mesh.is_closed);
  CHECK(mesh.triangle_count == 20);
  CHECK(mesh.node_count > mesh.leaf_count + 3);
}

TEST_CASE("known pairs: the pairs of triangles that intersect") {
  std::size_t rotated = 0;
  std::size_t translated = 0;
  detail::for_each_known_pose(1, [&](const Pose& pose) {
    REQUIRE(pose.status() == Status::done);
    NodePairs truth;
    brute_force(kMesh, kMesh.triangle_count, kMesh, kMesh.triangle_count, pose,
                [&](std::uint32_t i, std::uint32_t j) {
                  truth.emplace_back(kMesh.triangle_ids[i], kMesh.triangle_ids[j]);
                });
    NodePairs found;
    REQUIRE(for_each_pair(kMesh, kMesh, pose, [&](const PairQuery::Pair& pair) {
              found.emplace_back(pair.a, pair.b);
              return true;
            }) == Status::done);
    CHECK(sorted(found) == sorted(truth));
    (pose.is_translation() ? translated : rotated) += found.size();
  });
  CHECK(translated > 50);
  CHECK(rotated > 150);
}

TEST_CASE("known distances: the least of all pairs of triangles") {
  int apart = 0;
  detail::for_each_known_pose(3, [&](const Pose& pose) {
    const auto truth = least_of(all_distances(kMesh, kMesh, pose)).squared;
    const Clearance<std::uint16_t> found = distance(kMesh, kMesh, pose);
    REQUIRE(found.status == Status::done);
    CHECK(found.lower == lower_of(truth));
    CHECK(found.upper - found.lower <= 1);
    apart += found.lower != 0 ? 1 : 0;
  });
  CHECK(apart >= 8);
}
