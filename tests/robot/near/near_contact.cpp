// flashbvh_near_contact IMAGE [periods] [seed] [radians per period] [obstacle]
//
// Guards a robot baked by `flashbvh robot --format image` on moves near contact with several
// budgets, and prints a row per budget.
//
// flashbvh_near_contact --sound SECONDS ROBOT...
//
// Guards each robot for SECONDS, seed after seed, with and without an obstacle, at several speeds
// and budgets, and prints a row per robot. ROBOT: an image, or `arms`: the generated arms of the
// tests, a different one per seed.
#include <chrono>
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

constexpr std::uint32_t kBudgets[] = {500, 2000, UINT32_MAX - 1};
constexpr int kMovesOfPlace = 8;

void print(const GuardedMoves& moves) {
  const NearCounts& of = moves.counts();
  const auto share = [&](long count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(of.periods);
  };
  const std::string budget =
      moves.budget() == UINT32_MAX - 1 ? "unlimited" : std::to_string(moves.budget());
  std::printf(
      "| %s | %.2f | %.2f | %.3f | %ld | %ld | %ld | %.2f | %.2f | %ld | %ld | %.0f | %u |\n",
      budget.c_str(), share(of.not_yet_known), share(of.warned), share(of.falsely_warned), of.stops,
      of.early_stops, of.most_early, of.sum_over / static_cast<double>(std::max(1L, of.stops)),
      of.most_over, of.far_stops, of.unsound,
      static_cast<double>(of.work) / static_cast<double>(of.periods), of.most_work);
}

using Guards = std::vector<std::unique_ptr<GuardedMoves>>;

/// A guard for each budget.
template <std::size_t count>
Guards guards_of(const Robot& robot, const NearOptions& options,
                 const std::uint32_t (&budgets)[count]) {
  Guards guarded;
  for (const std::uint32_t budget : budgets) {
    guarded.push_back(std::make_unique<GuardedMoves>(robot, options, budget));
  }
  return guarded;
}

/// Runs all guards along the same moves from a place.
void run_at_place(const Guards& guarded, NearMoves& moves) {
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

int guard_moves(const Robot& robot, const NearOptions& options, long periods, std::uint64_t seed) {
  Random random(seed);
  const NearScene scene(robot, options);
  NearMoves moves(scene, options, random);
  const Guards guarded = guards_of(robot, options, kBudgets);
  while (guarded[0]->counts().periods < periods) {
    if (!moves.find_place()) {
      std::fprintf(stderr,
                   "no place near contact was found: a pair may never be over its stop "
                   "distance; bake with --pair LINK,LINK=0\n");
      return 1;
    }
    run_at_place(guarded, moves);
  }
  std::printf(
      "%ld periods, seed %llu, %g rad a period%s\n\n"
      "| work | not yet known, %% | warn, %% | false warn, %% | stops | early > 2 | most | "
      "over, mm | most | > 0.5 mm | unsound | mean work | most |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
      guarded[0]->counts().periods, static_cast<unsigned long long>(seed), options.turn,
      options.has_obstacle ? ", an obstacle" : "");
  long unsound = 0;
  for (const auto& of : guarded) {
    print(*of);
    unsound += of->counts().unsound;
  }
  return unsound != 0 ? 1 : 0;
}

/// The robot of an image, or null, with a message.
std::unique_ptr<tool::RobotFile> read(const char* path) {
  try {
    return std::make_unique<tool::RobotFile>(path);
  } catch (const tool::UserError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return nullptr;
  }
}

/// Sums over all seeds of a robot.
struct SoundCounts {
  long seeds = 0;
  long places = 0;
  long queries = 0;
  NearCounts of;
};

constexpr int kPlacesOfSeed = 10;
constexpr double kSpeeds[] = {1.25e-3, 5e-3, 2e-4};
constexpr std::uint32_t kSoundBudgets[] = {100, 500, 2000, UINT32_MAX - 1};

void guard_seed(const Robot& robot, std::uint64_t seed, SoundCounts& counts) {
  NearOptions options;
  options.turn = kSpeeds[seed % 3];
  options.slide = options.turn * 0.4;
  options.has_obstacle = seed % 2 == 0;
  Random random(seed);
  const NearScene scene(robot, options);
  NearMoves moves(scene, options, random);
  const Guards guarded = guards_of(robot, options, kSoundBudgets);
  for (int place = 0; place < kPlacesOfSeed && moves.find_place(400); ++place) {
    ++counts.places;
    run_at_place(guarded, moves);
  }
  ++counts.seeds;
  counts.queries += scene.oracle().queries();
  for (const auto& of : guarded) {
    const NearCounts& more = of->counts();
    counts.of.periods += more.periods;
    counts.of.not_yet_known += more.not_yet_known;
    counts.of.warned += more.warned;
    counts.of.stops += more.stops;
    counts.of.unsound += more.unsound;
    if (more.unsound != 0) {
      std::fprintf(stderr, "seed %llu, work %u: %ld unsound\n",
                   static_cast<unsigned long long>(seed), of->budget(), more.unsound);
    }
  }
}

/// False if the file is no robot's image, or a verdict is contradicted.
bool is_sound(const char* name, double seconds) {
  using Clock = std::chrono::steady_clock;
  const bool is_generated = std::strcmp(name, "arms") == 0;
  const auto file = is_generated ? nullptr : read(name);
  if (!is_generated && !file) {
    return false;
  }
  SoundCounts counts;
  const Clock::time_point began = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  for (std::uint64_t seed = 1; since() < seconds; ++seed) {
    if (is_generated) {
      Random random(seed);
      const FixedArm arm = any_guarded_arm(random, 3 + random.below(4), 1e-3);
      guard_seed(arm.robot(), seed, counts);
    } else {
      guard_seed(file->robot(), seed, counts);
    }
  }
  const NearCounts& of = counts.of;
  std::printf("| %s | %ld | %ld | %ld | %ld | %ld | %ld | %ld | %.0f | %ld |\n", name, counts.seeds,
              counts.places, of.periods, of.warned, of.not_yet_known, of.stops, counts.queries,
              static_cast<double>(of.periods) / since(), of.unsound);
  std::fflush(stdout);
  return of.unsound == 0;
}

int check_soundness(double seconds, const char* const* names) {
  std::printf(
      "| robot | seeds | places | periods | warned | not yet known | stops | queries | periods a "
      "second | unsound |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  bool is = true;
  for (; *names != nullptr; ++names) {
    is = is_sound(*names, seconds) && is;
  }
  return is ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 3 && std::strcmp(arguments[1], "--sound") == 0) {
    return check_soundness(std::atof(arguments[2]), arguments + 3);
  }
  if (count < 2) {
    std::fprintf(
        stderr,
        "usage: flashbvh_near_contact IMAGE [periods] [seed] [radians a period] [obstacle]\n"
        "       flashbvh_near_contact --sound SECONDS ROBOT...\n");
    return 2;
  }
  const auto file = read(arguments[1]);
  if (!file) {
    return 2;
  }
  NearOptions options;
  options.turn = count > 4 ? std::atof(arguments[4]) : options.turn;
  options.has_obstacle = count > 5;
  return guard_moves(file->robot(), options, count > 2 ? std::atol(arguments[2]) : 20000,
                     count > 3 ? std::strtoull(arguments[3], nullptr, 0) : 1);
}
