// Effects of a tolerance, against brute force over all pairs of triangles.
#include "flashbvh/clearance.hpp"
#include "support/all_distances.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

constexpr double kExact = 1e-12;  // the error of doubles

/// The reported distance exceeds the true one, and `lower`, by at most the tolerance.
void check_tolerance(const std::vector<Pairwise>& all, const Clearance<std::uint16_t>& found,
                     std::uint16_t tolerance) {
  const double truth = length_of(least_of(all).squared);
  const double longer = (1 + tolerance / 65536.0) * (1 + kExact);
  const auto reported = std::find_if(all.begin(), all.end(), [&](const Pairwise& pair) {
    return pair.of_a == found.witness.a && pair.of_b == found.witness.b;
  });
  REQUIRE(found.status == Status::done);
  REQUIRE(reported != all.end());
  const double distance = length_of(reported->squared);
  CAPTURE(tolerance, truth, distance, found.lower, found.upper);
  REQUIRE(distance <= truth * longer);
  REQUIRE(found.lower <= 256 * truth * (1 + kExact));
  REQUIRE((found.lower + 1) * longer >= 256 * distance);
  REQUIRE(found.upper >= 256 * distance * (1 - kExact));
  REQUIRE(found.upper < 256 * distance + 1);
}

}  // namespace

TEST_CASE("a tolerance is kept to, and said to be, from any seed") {
  for_rounds(rounds(120, 600), [&](Random& random, int round) {
    // Distances of a few cells and of many.
    const std::int32_t spread = round % 3 == 0 ? 400 : 4 + round % 7;
    const AnyMesh a = any_mesh(random, 14, spread, 1 + spread / 4);
    const AnyMesh b = any_mesh(random, 14, spread, 1 + spread / 4);
    const Pose pose = any_pose(random, 3 * spread);
    const std::vector<Pairwise> all = all_distances(a, b, pose);
    for (const unsigned tolerance : {0u, 1u, 655u, 32768u, 65535u}) {
      for (int i = 0; i < 4; ++i) {
        const Pairwise& any = random.one_of(all);
        Witness<std::uint16_t> begin;
        if (i != 0) {
          begin = {any.of_a, any.of_b};
        }
        const auto allowed = static_cast<std::uint16_t>(tolerance);
        ClearanceQuery query(a, b, pose, {begin, allowed});
        REQUIRE(query.run(UINT32_MAX).status == Status::done);
        check_tolerance(all, query.result(), allowed);
      }
    }
  });
}
