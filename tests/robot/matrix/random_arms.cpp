// Random arms against brute force: no `never` is contradicted by any configuration that was tried,
// none that is left unguarded comes within the stop distance, a `can` shows one, and at most 1 % of
// all pairs are left undecided. With an argument it tries as many configurations an arm; with a
// second one, as many arms.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <numeric>

#include "support/arms/arms.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using namespace flashbvh::test;

namespace {

/// How many of each verdict there are.
struct Counts {
  std::size_t of[6] = {};
  std::size_t operator[](MatrixVerdict verdict) const {
    return of[static_cast<std::size_t>(verdict)];
  }
  std::size_t all() const { return std::accumulate(std::begin(of), std::end(of), std::size_t{0}); }
};

/// In cells.
constexpr double kStop = 100;

bool is_contradicted(const BakedArm& arm, const PairVerdict& pair,
                     const std::vector<double>& variables) {
  return pair.verdict == MatrixVerdict::never &&
         (pair.is_guarded ? arm.intersect(pair.a, pair.b, variables)
                          : arm.are_within(pair.a, pair.b, variables, kStop));
}

/// False if a verdict is wrong.
bool try_arm(Random& random, const Model& model, long configurations, Counts& counts) {
  const BakedArm arm(model, 1e-4);
  MatrixOptions options;
  options.most_cells = 100'000;
  options.stop = kStop;
  const std::vector<PairVerdict> pairs = arm.decide(options);
  for (const PairVerdict& pair : pairs) {
    ++counts.of[static_cast<std::size_t>(pair.verdict)];
    if (pair.verdict == MatrixVerdict::can && !arm.intersect(pair.a, pair.b, pair.witness)) {
      std::printf("links %zu and %zu do not intersect at their witness\n", pair.a, pair.b);
      return false;
    }
  }
  for (long i = 0; i < configurations; ++i) {
    const std::vector<double> variables = any_variables(random, model);
    for (const PairVerdict& pair : pairs) {
      if (is_contradicted(arm, pair, variables)) {
        std::printf("links %zu and %zu: never, or far, but they are not\n", pair.a, pair.b);
        return false;
      }
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const long configurations = argc > 1 ? std::atol(argv[1]) : rounds(5'000L, 10'000L);
  const long arms = argc > 2 ? std::atol(argv[2]) : 8;
  std::printf("FLASHBVH_SEED=%llu\n", static_cast<unsigned long long>(test_seed()));
  Random random(test_seed());
  Counts counts;
  for (long i = 0; i < arms; ++i) {
    const Model model = any_arm(random, 3 + random.below(4));
    if (!try_arm(random, model, configurations, counts)) {
      std::printf("arm %ld\n", i);
      return 1;
    }
  }
  std::printf("%zu pairs: %zu never, %zu can, %zu always, %zu undecided, %zu fixed\n", counts.all(),
              counts[MatrixVerdict::never], counts[MatrixVerdict::can],
              counts[MatrixVerdict::always], counts[MatrixVerdict::undecided],
              counts[MatrixVerdict::fixed]);
  const bool both = counts[MatrixVerdict::never] > 0 && counts[MatrixVerdict::can] > 0;
  // Of fewer than a hundred pairs, one.
  const std::size_t most = std::max<std::size_t>(counts.all() / 100, 1);
  return both && counts[MatrixVerdict::undecided] <= most ? 0 : 1;
}
