// Guards near contact on random arms: what flashbvh_near_contact measures, small.
#include "guarded_moves.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

/// Arms of boxes have few triangles: these budgets are too small for some periods.
constexpr std::uint32_t kBudgets[] = {10, 100, UINT32_MAX - 1};

}  // namespace

TEST_CASE("near contact, and with an obstacle that moves, no verdict of a guard is contradicted") {
  long stops = 0;
  long late = 0;
  int places = 0;
  for_rounds(rounds(6, 60), [&](Random& random, int round) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    NearOptions options;
    options.has_obstacle = round % 2 == 0;
    const NearScene scene(arm.robot(), options);
    NearMoves moves(scene, options, random);
    if (!moves.find_place(1000)) {
      return;
    }
    ++places;
    for (const std::uint32_t budget : kBudgets) {
      GuardedMoves guarded(arm.robot(), options, budget);
      guarded.begin(moves.place());
      for (int i = 0; i < 2; ++i) {
        guarded.run(moves.move());
      }
      const NearCounts& counts = guarded.counts();
      CAPTURE(round, budget);
      REQUIRE(counts.unsound == 0);
      REQUIRE((budget < 1000 || counts.not_yet_known == 0));
      stops += counts.stops;
      late += counts.not_yet_known;
    }
  });
  CAPTURE(places, stops, late);
  CHECK(stops > 0);
  CHECK(late > 0);
}
