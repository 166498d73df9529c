// The way out, judged by force (drawn_robot.hpp): Guard::limit(), the verdicts of update(), and
// release().
//
// FLASHBVH_URDF: a robot too, as "URDF IMAGE [PACKAGE=FOLDER]...", IMAGE by `flashbvh robot
// --format image`. FLASHBVH_STARTS: starts inside. FLASHBVH_COMMANDS: to random targets.
#include <cstdio>
#include <iterator>
#include <sstream>
#include <string>

#include "robot/baked/robot_file.hpp"
#include "robot/pipeline/request.hpp"
#include "robot/read/urdf.hpp"
#include "support/arms/drawn_robot.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCreep = 1e-5;  // metres a command
constexpr std::uint32_t kBudgets[] = {5, 500, UINT32_MAX};

struct Counts {
  long commands = 0;  ///< by limit()
  long periods = 0;   ///< by update()
  long raised = 0;    ///< floors
  long leaving = 0;
  long checks = 0;
  long unsound = 0;
  long starts = 0;
  long first = 0;  ///< out at the first target
  long releases = 0;
  long released = 0;            ///< of these out
  long lines = 0;               ///< past a pair
  long alone = 0;               ///< periods of these without limit()
  long guarded = 0;             ///< with it
  double slowest = 0;           ///< of a line
  std::vector<long> until_out;  ///< commands of each start that came out
};

/// An arm that is sent and follows late, each command and each verdict judged.
struct Sent {
  Sent(Drawn& of, const Values& start, std::uint32_t budget, double delay, Counts& counted)
      : drawn(of),
        counts(counted),
        work(budget),
        lag(delay),
        now(start),
        late(start.begin(), start.end()) {
    REQUIRE(guard.prime(start.data()).status == Status::done);
  }
  /// Sends the arm, or moves it as it should not: then update() alone is judged.
  void command(const Values& wanted) {
    const Values before = std::exchange(now, wanted);
    if (obeys) {
      ++counts.commands;
      answer = guard.limit(wanted.data(), now.data(), work);
      REQUIRE(answer.status == Status::done);
      REQUIRE((answer.share == 0 || now != before || wanted == before));
      const std::vector<double> least = floors_at(before);
      judge("limit", false, before, now, [&](std::size_t i) { return drawn.kept(i, least[i]); });
    }
    const std::vector<Transform> frames = drawn.frames(now, 1);
    for (std::uint16_t i = 0; i < floors.size(); ++i) {
      // Less known than a command leaves would hold the arm for ever.
      const GuardPair& pair = state->pairs[i];
      const double least = guard.floor(i) - std::min(drawn.give(i), guard.floor(i) / 2.0) / 2;
      REQUIRE((pair.granted + 1.0 >= least || is_released(i) || drawn.has_obstacle(i)));
      // Nor more than was measured.
      const double most = std::min<double>(pair.granted, drawn.limit(i, 1, 2));
      const double apart = most - drawn.deviation(i) - drawn.rounding;
      const bool is_known = obeys && pair.granted != kNotMeasured && !is_released(i);
      counts.unsound += is_known && apart > 0 && drawn.is_nearer(i, frames, apart) ? 1 : 0;
      counts.raised += floors[i] > 0 && guard.floor(i) > floors[i] ? 1 : 0;
      floors[i] = std::max<double>(floors[i], guard.floor(i));
    }
    const std::uint32_t judged = drawn.random.below(drawn.sample);
    for (std::uint32_t i = 0; i < drawn.sample; ++i) {
      follow(i == judged);
    }
  }
  /// The floors that a command keeps. An obstacle lowers those of its pairs, but not below what
  /// they are apart, as measured: to a 32nd.
  std::vector<double> floors_at(const Values& start) {
    std::vector<double> least = floors;
    const std::vector<Transform> frames = drawn.frames(start, 1);
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (drawn.has_obstacle(i)) {
        const double apart = real_between(drawn.random, 0, drawn.limit(i, 1, 1));
        const double measured = (apart - drawn.deviation(i)) * 31 / 32 - 3 * drawn.rounding;
        least[i] = drawn.is_nearer(i, frames, apart) ? 0 : std::max(measured, 0.0);
      }
    }
    return least;
  }
  /// The robot follows, each joint in its own time, and its values are updated.
  void follow(bool is_judged) {
    ++counts.periods;
    const Values before(late.begin(), late.end());
    for (std::size_t i = 0; i < now.size(); ++i) {
      late[i] += (now[i] - late[i]) / (lag * static_cast<double>(1 + i % 3));
    }
    const Values values(late.begin(), late.end());
    std::vector<double> seen;
    for (std::size_t i = 0; is_judged && i < floors.size(); ++i) {
      const GuardPair& pair = state->pairs[i];
      const std::uint32_t own = (pair.seen & kOwn) != 0 ? pair.lower : 0;
      seen.push_back(std::min<double>(std::max(pair.seen & ~kOwn, own), drawn.limit(i, 1, 1)));
    }
    if (drawn.room != nullptr) {
      drawn.room->move(drawn.frames(now, 1));
    }
    const GuardAnswer is = guard.update(values.data(), work);
    REQUIRE(is.status == Status::done);
    counts.leaving += is.verdict == Verdict::leaving ? 1 : 0;
    if (!is_judged) {
      return;
    }
    judge("update", true, before, values, [&](std::size_t i) {
      const RobotPair& pair = drawn.robot.pairs[i];
      const double floor = is_released(i) ? 0 : drawn.kept(i, seen[i]);
      return is.verdict == Verdict::free      ? pair.warn
             : is.verdict == Verdict::warn    ? pair.stop
             : is.verdict == Verdict::leaving ? std::min<double>(floor, pair.stop)
                                              : 0;
    });
  }
  /// Tests the end, and a few places of the box between. `kept(i)`: what a pair keeps. `moves`: so
  /// does an obstacle.
  template <class Kept>
  void judge(const char* what, bool moves, const Values& from, const Values& to, const Kept& kept) {
    const bool is_still = from == to && (!moves || drawn.room == nullptr);
    const std::uint32_t places = is_still ? 1 : 2 + drawn.random.below(3);
    for (std::uint32_t place = 0; place < places; ++place) {
      Values at = to;
      for (std::size_t i = 0; place != 0 && i < at.size(); ++i) {
        const double parts[] = {0, 1, real_between(drawn.random, 0, 1)};
        const double way = drawn.random.one_of(parts) * (double(to[i]) - from[i]);
        at[i] = from[i] + static_cast<std::int32_t>(way);
      }
      const std::vector<Transform> frames =
          drawn.frames(at, moves && place != 0 ? real_between(drawn.random, 0, 1) : 1);
      for (std::size_t i = 0; i < floors.size(); ++i) {
        counts.checks += kept(i) > 0 ? 1 : 0;
        if (kept(i) > 0 && drawn.is_nearer(i, frames, kept(i)) && ++counts.unsound <= 5) {
          std::printf("unsound: %s, %s at %.5f mm, work %u, period %ld\n", what,
                      drawn.name_of(i).c_str(), kept(i) * drawn.cell / kFineOne * 1000, work,
                      counts.periods);
        }
      }
    }
  }

  bool is_out() const {
    bool is = true;
    for (std::size_t i = 0; is && i < floors.size(); ++i) {
      is = drawn.left_out[i] || !drawn.is_within(i, now, drawn.limit(i, 1, 0));
    }
    return is;
  }
  bool is_released(std::size_t i) const { return state->pairs[i].floor >= kReleased; }
  /// Releases the pair that holds the arm, if it touches.
  bool releases() {
    const std::uint16_t i = answer.pair;
    const auto creep = static_cast<std::uint32_t>(kCreep / drawn.cell * kFineOne);
    const bool does = guard.floor(i) < 4 * drawn.rounding && !is_released(i);
    floors[i] = does ? 0 : floors[i];
    return does && guard.release(i, {creep}) == Status::done;
  }
  /// Goes there until it is out, or is held.
  bool goes_out(const Values& target, bool may_release, long& periods) {
    double shares = 0;
    for (long i = 1; i <= 5000 && now != target; ++i) {
      command(drawn.step(now, target, 1));
      ++periods;
      if (is_out()) {
        return true;
      }
      shares += answer.share;
      const bool creeps = i % 200 == 0 && !may_release && std::exchange(shares, 0) < 4096;
      if (creeps || (answer.verdict == LimitVerdict::held && !(may_release && releases()))) {
        break;
      }
    }
    return false;
  }

  using State = GuardStateOf<kMaxJoints, 512, 4096>;
  Drawn& drawn;
  Counts& counts;
  std::uint32_t work;
  double lag;  ///< in periods
  bool obeys = true;
  std::unique_ptr<State> state = std::make_unique<State>();
  Guard guard{drawn.robot, *state};
  LimitAnswer answer{};  ///< the last one
  Values now;
  std::vector<double> late;  ///< the measured values, before rounding
  std::vector<double> floors = std::vector<double>(drawn.robot.pair_count);  ///< the largest so far
};

/// Sends the arm to random targets, or there and back near a place inside or just outside.
void send_anywhere(Drawn& drawn, Counts& counts) {
  Random& random = drawn.random;
  const std::uint32_t kind = random.below(3);
  const Values place = kind == 0 ? drawn.any()
                       : kind == 1
                           ? drawn.start(false)
                           : drawn.border(drawn.any(true, 0, 0), 1, real_between(random, 0, 2));
  const double reach = kind == 0 || random.below(2) == 0 ? 1 : 0.05;
  const double speeds[] = {0.1, 1, 20};
  const double lags[] = {1, 5, 20};
  Sent sent(drawn, place, random.one_of(kBudgets), random.one_of(lags), counts);
  const double speed = random.one_of(speeds);
  sent.obeys = random.below(2) == 0;
  Values target = place;
  std::size_t one = 0;
  bool turns_one = false;
  for (int i = 0; i < 150; ++i) {
    const bool turns = sent.now == target || random.below(50) == 0;
    target = turns ? Drawn::between(place, drawn.any(), reach) : target;
    one = turns ? random.below(static_cast<std::uint32_t>(place.size())) : one;
    turns_one = turns ? random.below(3) == 0 : turns_one;
    Values next = drawn.step(sent.now, target, speed);
    for (std::size_t joint = 0; joint < next.size() && turns_one; ++joint) {
      next[joint] = joint == one ? next[joint] : sent.now[joint];
    }
    sent.command(next);
  }
}

/// Sends an arm that is inside, or that intersects and is released, to free places until it is out.
void send_out(Drawn& drawn, bool is_release, Counts& counts) {
  Sent sent(drawn, drawn.start(is_release), UINT32_MAX, 5, counts);
  if (sent.is_out()) {
    return;
  }
  long periods = 0;
  int targets = 0;
  bool is_out = false;
  for (; !is_out && targets < (is_release ? 5 : 20); ++targets) {
    is_out = sent.goes_out(drawn.free_place(), is_release, periods);
  }
  ++(is_release ? counts.releases : counts.starts);
  if (is_release) {
    counts.released += is_out ? 1 : 0;
  } else if (is_out) {
    counts.first += targets == 1 ? 1 : 0;
    counts.until_out.push_back(periods);
  } else {
    const std::uint16_t by = sent.answer.pair;
    std::printf("start %ld stays: limit's verdict %d, %s\n", counts.starts,
                int(sent.answer.verdict), by == kNoPair ? "no pair" : drawn.name_of(by).c_str());
  }
}

/// Sends the arm on a straight line that passes the pairs at their stop distances and 2 mm, if one
/// is found.
void send_past(Drawn& drawn, Counts& counts) {
  const double beyond = 2e-3 / drawn.cell * kFineOne;
  const Values from = drawn.free_place();
  // Places on the way, each `skipped` periods.
  const auto is_near = [&](const Values& to, double by, double skipped) {
    bool is = drawn.is_near(to, 1, 0, 2 * by);
    for (Values at = from; !is && at != to; at = drawn.step(at, to, skipped)) {
      is = drawn.is_near(at, 1, 0, by);
    }
    return is;
  };
  Values over = from;
  Values wrong = from;
  for (int i = 0; i < 40 && (over == from || wrong == from); ++i) {
    const Values to = Drawn::between(from, drawn.any(), 0.3);
    (is_near(to, beyond, 8) ? wrong : over) = to;
  }
  for (int i = 0; i < 12; ++i) {
    const Values middle = Drawn::between(over, wrong, 0.5);
    (is_near(middle, beyond, 8) ? wrong : over) = middle;
  }
  if (over == from || wrong == from || is_near(over, 0.9 * beyond, 1)) {
    return;
  }
  long alone = 0;
  for (Values at = from; at != over; at = drawn.step(at, over, 1)) {
    ++alone;
  }
  Sent sent(drawn, from, 500, 1, counts);
  long guarded = 0;
  for (; sent.now != over && guarded < 20 * alone; ++guarded) {
    sent.command(drawn.step(sent.now, over, 1));
  }
  const std::uint16_t by = sent.answer.pair;
  if (sent.now != over && by != kNoPair && drawn.left_out[by]) {
    return;
  }
  ++counts.lines;
  counts.alone += alone;
  counts.guarded += guarded;
  counts.slowest = std::max(counts.slowest, double(guarded) / double(alone));
}

/// Half of the commands with an obstacle.
void send(const Robot& robot, const Model& model, Random& random, long starts, long commands,
          Counts& counts) {
  Drawn drawn(robot, model, random);
  for (long i = 0; i < number_in("FLASHBVH_LINES", 2); ++i) {
    random = test_random(static_cast<std::uint64_t>(i) + 1);
    send_past(drawn, counts);
  }
  for (long i = 0; i < starts; ++i) {
    send_out(drawn, false, counts);
    if (i % 5 == 0) {
      send_out(drawn, true, counts);
    }
  }
  for (std::size_t i = 0; i < drawn.left_out.size(); ++i) {
    if (drawn.left_out[i]) {
      std::printf("left out of the starts: %s\n", drawn.name_of(i).c_str());
    }
  }
  for (const long end = counts.commands + commands / 2; counts.commands < end;) {
    send_anywhere(drawn, counts);
  }
  Room room(robot, model.links.size(), random);
  Drawn crowded(room.workcell.robot(), model, random, &room);
  for (const long end = counts.commands + commands / 2; counts.commands < end;) {
    send_anywhere(crowded, counts);
  }
}

void check(const std::string& name, Counts& of) {
  std::sort(of.until_out.begin(), of.until_out.end());
  const std::size_t out = of.until_out.size();
  std::printf("| %s | %ld | %ld | %zu | %ld | %ld | %ld of %ld | %ld | %ld | %ld | %ld |\n",
              name.c_str(), of.starts, of.first, out, out == 0 ? 0 : of.until_out[out / 2],
              out == 0 ? 0 : of.until_out.back(), of.released, of.releases, of.commands, of.periods,
              of.checks, of.unsound);
  std::printf("| %s | past a pair: %ld lines | %.3f of the time | slowest %.2f |\n", name.c_str(),
              of.lines, double(of.guarded) / std::max(1.0, double(of.alone)), of.slowest);
  CHECK(of.unsound == 0);
  CHECK(double(of.guarded) <= 1.3 * double(of.alone));
}

}  // namespace

TEST_CASE("the way out: by force, no pair of an arm gets nearer than promised, and arms come out") {
  CAPTURE(test_seed());
  Random random = test_random();
  Counts all;
  for (int arms = 0; arms < rounds(16, 400); ++arms) {
    const FixedArm arm(any_guarded_arm(random, 3 + random.below(3), 5e-5));
    send(arm.robot(), arm.model, random, 2, 300, all);
  }
  check("random arms", all);
  CHECK(2 * static_cast<long>(all.until_out.size()) >= all.starts);
  CHECK(all.released > 0);
  CHECK(all.raised > 0);
  CHECK(all.leaving > 0);
}

TEST_CASE("the way out: a robot of FLASHBVH_URDF", "[.]") {
  Random random = test_random();
  const char* const robot = setting("FLASHBVH_URDF");
  std::istringstream words(robot == nullptr ? "" : robot);
  std::vector<std::string> files(std::istream_iterator<std::string>(words), {});
  REQUIRE(files.size() >= 2);
  Warnings warnings;
  const RobotFile image(files[1]);
  const Packages packages = packages_of({files.begin() + 2, files.end()});
  const Model model = read_urdf(files[0], packages, "", warnings);
  Counts counts;
  send(image.robot(), model, random, number_in("FLASHBVH_STARTS", 20),
       number_in("FLASHBVH_COMMANDS", 20'000), counts);
  check(files[1], counts);
}
