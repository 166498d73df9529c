// Guards near contact on random arms: a small version of flashbvh_near_contact.
#include "guarded_moves.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

/// Arms made of boxes have few triangles: these budgets are too small in some periods.
constexpr std::uint32_t kBudgets[] = {10, 100, UINT32_MAX - 1};

/// Calls body(random, arm, scene, moves, options) at places near contact of random arms; half of
/// them have an obstacle.
template <class Body>
void for_each_place(const Body& body) {
  for_rounds(rounds(6, 60), [&](Random& random, int round) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    NearOptions options;
    options.has_obstacle = round % 2 == 0;
    const NearScene scene(arm.robot(), options);
    NearMoves moves(scene, options, random);
    if (moves.find_place(1000)) {
      body(random, arm, scene, moves, options);
    }
  });
}

}  // namespace

TEST_CASE("what is known of distances without a query holds") {
  long narrow = 0;
  for_each_place([&](Random& random, const FixedArm&, const NearScene& scene, NearMoves& moves,
                     const NearOptions&) {
    NearOracle oracle(scene.robot());
    for (int i = 0; i < 4; ++i) {
      const NearMove move = moves.move();
      for (std::size_t at = 0; at < move.size(); at += 1 + random.below(8)) {
        const std::vector<Pose> poses = scene.poses(move[at]);
        for (std::uint32_t j = 0; j < poses.size(); ++j) {
          const RobotPair& pair = scene.robot().pairs[j];
          const NearBounds bounds = oracle.bounds(j, poses[j]);
          const auto found =
              distance(scene.robot().meshes[pair.a], scene.robot().meshes[pair.b], poses[j]);
          CAPTURE(i, at, j, bounds.lower, bounds.upper, found.lower);
          REQUIRE(bounds.lower <= found.upper);
          REQUIRE((!found.in_range || bounds.upper >= found.lower));
          narrow += bounds.upper - bounds.lower < 2000 ? 1 : 0;
          if (random.below(4) == 0) {
            const NearBounds measured = oracle.measured(j, poses[j]);
            REQUIRE(measured.lower == found.lower);
            REQUIRE(measured.upper == found.lower);
          }
        }
      }
    }
  });
  CHECK(narrow > 0);
}

TEST_CASE("near contact, and with an obstacle that moves, no verdict of a guard is contradicted") {
  long stops = 0;
  long late = 0;
  for_each_place([&](Random&, const FixedArm& arm, const NearScene&, NearMoves& moves,
                     const NearOptions& options) {
    for (const std::uint32_t budget : kBudgets) {
      GuardedMoves guarded(arm.robot(), options, budget);
      guarded.begin(moves.place());
      for (int i = 0; i < 2; ++i) {
        guarded.run(moves.move());
      }
      const NearCounts& counts = guarded.counts();
      CAPTURE(budget);
      REQUIRE(counts.unsound == 0);
      REQUIRE((budget < 1000 || counts.not_yet_known == 0));
      stops += counts.stops;
      late += counts.not_yet_known;
    }
  });
  CAPTURE(stops, late);
  CHECK(stops > 0);
  CHECK(late > 0);
}
