#include "guarded_moves.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::test {
namespace {

constexpr std::size_t kStateWords = 40000;

std::uint32_t way_between(const Frame& from, const Frame& to) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    squared += std::pow(double(to.translation[axis]) - from.translation[axis], 2);
  }
  return static_cast<std::uint32_t>(std::sqrt(squared) / kFrameCell * 256) + 1;
}

}  // namespace

NearCounts& NearCounts::operator+=(const NearCounts& more) {
  periods += more.periods;
  not_yet_known += more.not_yet_known;
  warned += more.warned;
  unsound += more.unsound;
  stops += more.stops;
  early_stops += more.early_stops;
  most_early = std::max(most_early, more.most_early);
  work += more.work;
  most_work = std::max(most_work, more.most_work);
  return *this;
}

GuardedMoves::GuardedMoves(const Robot& robot, const NearOptions& options, std::uint32_t budget)
    : scene_(robot, options),
      budget_(budget),
      memory_(kStateWords),
      guard_(scene_.robot(), memory_.data(), kStateWords * sizeof memory_[0]) {}

void GuardedMoves::begin(const NearMoment& place) {
  scene_.move(place.obstacle, 0);
  (void)guard_.prime(place.values.data());
}

void GuardedMoves::run(const NearMove& move) {
  std::size_t at = 0;
  while (at + 1 < move.size() && !step(move, at, at + 1, true)) {
    ++at;
  }
  for (at = at + 1 < move.size() ? at + 1 : 0; at != 0; --at) {
    (void)step(move, at, at - 1, false);
  }
}

bool GuardedMoves::step(const NearMove& move, std::size_t from, std::size_t to, bool goes_on) {
  scene_.move(move[to].obstacle, way_between(move[from].obstacle, move[to].obstacle));
  const GuardAnswer answer = guard_.update(move[to].values.data(), budget_);
  ++counts_.periods;
  counts_.work += answer.work;
  counts_.most_work = std::max(counts_.most_work, answer.work);
  counts_.not_yet_known += answer.verdict == Verdict::not_yet_known ? 1 : 0;
  check(move, from, to, answer);
  if (answer.verdict == Verdict::stop && goes_on) {
    count_stop(move, to);
  }
  return answer.verdict == Verdict::stop || !move.distances(to).are_over(0);
}

void GuardedMoves::check(const NearMove& move, std::size_t from, std::size_t to,
                         const GuardAnswer& answer) {
  const Robot& robot = scene_.robot();
  const NearDistances& before = move.distances(from);
  const NearDistances& now = move.distances(to);
  bool is_sound =
      answer.status == Status::done && now.is_beyond(answer.pair, double(answer.distance) - 1);
  for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    const auto are_beyond = [&](double limit) {
      return before.is_beyond(i, limit) && now.is_beyond(i, limit);
    };
    is_sound = is_sound && (answer.verdict > Verdict::warn ||
                            are_beyond(answer.verdict == Verdict::free ? pair.warn : pair.stop));
  }
  counts_.unsound += is_sound ? 0 : 1;
  counts_.warned += answer.verdict == Verdict::warn ? 1 : 0;
}

void GuardedMoves::count_stop(const NearMove& move, std::size_t at) {
  const std::uint32_t slack = scene_.robot().slack;
  ++counts_.stops;
  std::size_t contact = at;
  while (contact < move.size() && move.distances(contact).are_over(slack)) {
    ++contact;
  }
  const auto early = static_cast<long>(contact - at);
  if (contact != move.size()) {
    counts_.early_stops += early > 2 ? 1 : 0;
    counts_.most_early = std::max(counts_.most_early, early);
  }
}

}  // namespace flashbvh::test
