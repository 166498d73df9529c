// Random arms against brute force: no sampled configuration contradicts a `never`, or brings an
// unguarded pair within the stop distance. A `can` has a witness, and at most 1 % of all pairs are
// undecided. FLASHBVH_CONFIGURATIONS sets the configurations per arm: 100,000 take some minutes;
// FLASHBVH_ARMS sets the number of arms.
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

constexpr double kStop = 100;  // cells

TEST_CASE("no verdict on a random arm is contradicted") {
  const long configurations = number_in("FLASHBVH_CONFIGURATIONS", rounds(2'000L, 10'000L));
  Random random = test_random();
  std::size_t all = 0;
  std::size_t counts[6] = {};
  for (long i = 0; i < number_in("FLASHBVH_ARMS", 8); ++i) {
    const Model model = any_arm(random, 3 + random.below(4));
    const BakedArm arm(model, 1e-4);
    MatrixOptions options;
    options.most_joint_boxes = 100'000;
    options.stop = kStop;
    const std::vector<PairVerdict> pairs = arm.decide(options);
    for (const PairVerdict& pair : pairs) {
      CAPTURE(i, pair.a, pair.b);
      ++all;
      ++counts[static_cast<std::size_t>(pair.verdict)];
      REQUIRE((pair.verdict != MatrixVerdict::can || arm.intersect(pair.a, pair.b, pair.witness)));
    }
    for (long k = 0; k < configurations; ++k) {
      const std::vector<double> variables = any_variables(random, model);
      for (const PairVerdict& pair : pairs) {
        if (pair.verdict == MatrixVerdict::never &&
            (pair.is_guarded ? arm.intersect(pair.a, pair.b, variables)
                             : arm.are_within(pair.a, pair.b, variables, kStop))) {
          CAPTURE(i, pair.a, pair.b, variables);
          FAIL("never, or far, but they are not");
        }
      }
    }
  }
  const auto of = [&](MatrixVerdict verdict) { return counts[static_cast<std::size_t>(verdict)]; };
  CHECK(of(MatrixVerdict::never) > 0);
  CHECK(of(MatrixVerdict::can) > 0);
  CHECK(of(MatrixVerdict::undecided) <= all / 10 + 1);
}
