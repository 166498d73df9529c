// flashbvh_near_contact IMAGE [periods] [seed] [radians per period] [obstacle]
//
// Guards a robot baked by `flashbvh robot --format image` on moves near contact with several
// budgets, and prints a row for each of them.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "flashbvh/robot/image.hpp"
#include "guarded_moves.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr std::uint32_t kBudgets[] = {500, 2000, UINT32_MAX - 1};
constexpr int kMovesOfPlace = 8;

std::vector<std::uint32_t> words_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::uint32_t> words(bytes.size() / 4 + 1);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
  return words;
}

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

int guard_moves(const Robot& robot, const NearOptions& options, long periods, std::uint64_t seed) {
  Random random(seed);
  const NearScene scene(robot, options);
  NearMoves moves(scene, options, random);
  std::vector<std::unique_ptr<GuardedMoves>> guarded;
  for (const std::uint32_t budget : kBudgets) {
    guarded.push_back(std::make_unique<GuardedMoves>(robot, options, budget));
  }
  while (guarded[0]->counts().periods < periods) {
    if (!moves.find_place()) {
      std::fprintf(stderr,
                   "no place near contact was found: a pair may never be over its stop "
                   "distance; bake with --pair LINK,LINK=0\n");
      return 1;
    }
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

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(
        stderr,
        "usage: flashbvh_near_contact IMAGE [periods] [seed] [radians a period] [obstacle]\n");
    return 2;
  }
  const std::vector<std::uint32_t> words = words_of(arguments[1]);
  std::vector<Mesh> meshes(kMaxLinks);
  Robot robot{};
  const Status status = open_robot(words.data(), words.size() * 4, meshes.data(), kMaxLinks, robot);
  if (status != Status::done) {
    std::fprintf(stderr, "%s: no robot image (%s)\n", arguments[1], status_name(status));
    return 2;
  }
  NearOptions options;
  options.turn = count > 4 ? std::atof(arguments[4]) : options.turn;
  options.has_obstacle = count > 5;
  return guard_moves(robot, options, count > 2 ? std::atol(arguments[2]) : 20000,
                     count > 3 ? std::strtoull(arguments[3], nullptr, 0) : 1);
}
