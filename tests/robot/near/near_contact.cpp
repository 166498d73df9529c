// flashbvh_near_contact PERIODS SEED ROBOT...
//
// Guards robots on moves near contact, seed after seed from SEED on, with and without an obstacle,
// at several speeds and budgets, for PERIODS at each budget; prints a row for each robot and
// budget. ROBOT: an image of `flashbvh robot --format image`, or `arms`: the generated arms of the
// tests, another for each seed. Exit status 1 if a distance contradicts a verdict.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "guarded_moves.hpp"
#include "robot/baked/robot_file.hpp"
#include "support/arms/guarded_arm.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr std::uint32_t kBudgets[] = {100, 500, 2000, UINT32_MAX - 1};
constexpr std::size_t kBudgetCount = std::size(kBudgets);
constexpr double kSpeeds[] = {1.25e-3, 5e-3, 2e-4};  // radians a period
constexpr int kPlacesOfSeed = 10;
constexpr int kMovesOfPlace = 8;
/// After so many seeds without a place near contact a robot has none.
constexpr int kSeedsWithoutPlace = 20;

using Counts = std::array<NearCounts, kBudgetCount>;

/// Guards the robot on the moves of one seed, the same with each budget.
void guard_seed(const Robot& robot, std::uint64_t seed, Counts& counts) {
  NearOptions options;
  options.turn = kSpeeds[seed % std::size(kSpeeds)];
  options.slide = options.turn * 0.4;
  options.has_obstacle = seed % 2 == 0;
  Random random(seed);
  const NearScene scene(robot, options);
  NearMoves moves(scene, options, random);
  std::vector<std::unique_ptr<GuardedMoves>> guarded;
  for (const std::uint32_t budget : kBudgets) {
    guarded.push_back(std::make_unique<GuardedMoves>(robot, options, budget));
  }
  for (int place = 0; place < kPlacesOfSeed && moves.find_place(400); ++place) {
    for (const auto& of : guarded) {
      of->begin(moves.place());
    }
    for (int i = 0; i < kMovesOfPlace; ++i) {
      const NearMove move = moves.move();
      for (const auto& of : guarded) {
        of->run(move);
      }
    }
  }
  for (std::size_t i = 0; i < kBudgetCount; ++i) {
    if (guarded[i]->counts().unsound != 0) {
      std::fprintf(stderr, "seed %llu, work %u: %ld unsound\n",
                   static_cast<unsigned long long>(seed), kBudgets[i],
                   guarded[i]->counts().unsound);
    }
    counts[i] += guarded[i]->counts();
  }
}

void print(const char* name, std::uint32_t budget, const NearCounts& of) {
  const auto share = [&](long count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(of.periods);
  };
  const std::string work = budget == kBudgets[kBudgetCount - 1] ? "all" : std::to_string(budget);
  std::printf("| %s | %s | %ld | %.2f | %.2f | %ld | %ld | %ld | %ld | %.0f | %u |\n", name,
              work.c_str(), of.periods, share(of.not_yet_known), share(of.warned), of.stops,
              of.early_stops, of.most_early, of.unsound,
              static_cast<double>(of.work) / static_cast<double>(of.periods), of.most_work);
}

/// False if the robot has no place near contact, or a verdict is contradicted.
bool is_sound(const char* name, long periods, std::uint64_t seed) {
  const bool is_generated = std::strcmp(name, "arms") == 0;
  const auto file = is_generated ? nullptr : std::make_unique<tool::RobotFile>(name);
  Counts counts;
  for (int seeds = 0; counts[0].periods < periods; ++seeds, ++seed) {
    if (seeds == kSeedsWithoutPlace && counts[0].periods == 0) {
      std::fprintf(stderr,
                   "%s: no place near contact was found: a pair may never be over its stop "
                   "distance; bake with --pair LINK,LINK=0\n",
                   name);
      return false;
    }
    if (is_generated) {
      Random random(seed);
      const std::uint32_t joints = 3 + random.below(4);
      guard_seed(any_guarded_arm(random, joints, 1e-3).robot(), seed, counts);
    } else {
      guard_seed(file->robot(), seed, counts);
    }
  }
  bool is = true;
  for (std::size_t i = 0; i < kBudgetCount; ++i) {
    print(name, kBudgets[i], counts[i]);
    is = is && counts[i].unsound == 0;
  }
  std::fflush(stdout);
  return is;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr, "usage: flashbvh_near_contact PERIODS SEED ROBOT...\n");
    return 2;
  }
  std::printf(
      "| robot | work | periods | not yet known, %% | warn, %% | stops | early > 2 | most | "
      "unsound | mean work | most |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  bool is = true;
  for (int i = 3; i < count; ++i) {
    try {
      is = is_sound(arguments[i], std::atol(arguments[1]),
                    std::strtoull(arguments[2], nullptr, 0)) &&
           is;
    } catch (const tool::UserError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      is = false;
    }
  }
  return is ? 0 : 1;
}
