// The way out, judged by force: Guard::limit(), the verdicts of update(), and release(). The judge
// places the URDF's links in doubles and shares no code with the library. Parts outside a joint's
// zone are as baked.
//
// FLASHBVH_URDF: a robot too, as "URDF IMAGE [PACKAGE=FOLDER]...", IMAGE by `flashbvh robot
// --format image`. FLASHBVH_STARTS: starts inside. FLASHBVH_PERIODS: of random targets.
#include <cstdio>
#include <iterator>
#include <sstream>
#include <string>

#include "robot/baked/robot_file.hpp"
#include "robot/pipeline/request.hpp"
#include "robot/read/urdf.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/oracles/drawn_mesh.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kTurn = 3e-3;   // radians a period
constexpr double kSlide = 2e-4;  // metres a period
constexpr double kCreep = 1e-5;  // metres a command
constexpr std::uint32_t kBudgets[] = {5, 500, UINT32_MAX};

struct Counts {
  long commands = 0;
  long raised = 0;  ///< floors
  long leaving = 0;
  long checks = 0;
  long unsound = 0;
  long starts = 0;
  long first = 0;  ///< out at the first target
  long releases = 0;
  long released = 0;          ///< of these out
  std::vector<long> periods;  ///< of each start that came out
};

/// A robot as firmware has it and as drawn, and places of it. Distances are in 1/256 cell.
struct Drawn {
  Drawn(const Robot& of, Model as_drawn, Random& numbers)
      : robot(of), model(std::move(as_drawn)), random(numbers) {
    for (std::uint32_t i = 0; i < robot.link_count; ++i) {
      meshes.emplace_back(i < model.links.size() ? triangles_of(model.links[i].mesh)
                                                 : as_baked(robot.meshes[i]));
      rounding = std::min(rounding, double(robot.slack) - 2.0 * robot.links[i].deviation);
    }
    for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
      int near = 0;
      while (near < 400 && is_within(i, any(), limit(i, 1, 2))) {
        ++near;
      }
      left_out.push_back(near == 400);
    }
  }

  std::vector<FloatTriangle> as_baked(const Mesh& mesh) const {
    const std::vector<Vector3> vertices = vertices_of(mesh);
    std::vector<FloatTriangle> triangles(mesh.triangle_count);
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
      triangles[i / 3][i % 3] = times(cell, vertices[mesh.triangles[i / 3].corner[i % 3]]);
    }
    return triangles;
  }
  std::string name_of(std::size_t i) const {
    const auto name = [&](std::size_t link) {
      return link < model.links.size() ? model.links[link].name : "part " + std::to_string(link);
    };
    return name(robot.pairs[i].a) + " - " + name(robot.pairs[i].b);
  }
  double give(std::size_t i) const { return std::max(robot.pairs[i].stop / 10.0, 8 * rounding); }
  double deviation(std::size_t i) const {
    return double(robot.links[robot.pairs[i].a].deviation) +
           robot.links[robot.pairs[i].b].deviation;
  }
  /// A part of the stop distance, as measured, and of the give.
  double limit(std::size_t i, double part, double gives) const {
    return part * (double(robot.pairs[i].stop) + robot.slack) + gives * give(i);
  }
  /// What a floor promises.
  double kept(std::size_t i, double floor) const {
    return floor - std::min(give(i), floor / 2) - deviation(i);
  }
  double unit_of(std::size_t variable) const {
    return unit_of_coordinate(robot.joints[model.variables[variable]].type, cell);
  }
  std::vector<Transform> frames(const Values& values) const {
    std::vector<double> variables;
    for (std::size_t i = 0; i < values.size(); ++i) {
      variables.push_back(values[i] * unit_of(i));
    }
    return frames_of(model, variables);
  }
  bool is_nearer(std::size_t i, const std::vector<Transform>& frames, double distance) const {
    const RobotPair& of = robot.pairs[i];
    const auto frame_of = [&](std::size_t link) {
      const std::size_t joint = joint_of(robot.links[link].joint);
      return joint == kNoJoint ? Transform() : frames[joint];
    };
    const Transform frame = composed(inverse(frame_of(of.a)), frame_of(of.b));
    return meshes[of.a].is_nearer(meshes[of.b], frame, distance * cell / kFineOne);
  }
  /// As baked: only for starts and for success.
  bool is_within(std::size_t i, const Values& at, double distance) const {
    const RobotPair& of = robot.pairs[i];
    const PlacedLinks links(robot, coordinates_of(robot, at));
    const FineLength length = {std::min(static_cast<std::uint32_t>(distance), kMaxGuardDistance)};
    return closer_than(robot.meshes[of.a], robot.meshes[of.b], links.pose(of.a, of.b), length).yes;
  }
  /// Whether any pair is; if `part` is 0, a pair that is left out counts, too.
  bool is_near(const Values& at, double part, double gives, double roundings = 0) const {
    bool is = false;
    for (std::size_t i = 0; !is && i < robot.pair_count; ++i) {
      is = (part == 0 || !left_out[i]) &&
           is_within(i, at, limit(i, part, gives) + roundings * rounding);
    }
    return is;
  }
  Values any() const {
    Values values;
    for (const std::size_t number : model.variables) {
      const RobotJoint& joint = robot.joints[number];
      const std::int32_t half = joint.type == JointType::continuous ? kFullTurn / 2 - 1 : 0;
      values.push_back(
          random.between(half == 0 ? joint.lower : -half, half == 0 ? joint.upper : half));
    }
    return values;
  }
  /// Any place that is near, or is not; the last one tried if none is found.
  Values any(bool is, double part, double gives) const {
    Values values = any();
    for (int i = 0; i < 400 && is_near(values, part, gives) != is; ++i) {
      values = any();
    }
    return values;
  }
  Values free_place() const { return any(false, 1, 2); }
  /// Where pairs get near on the way from a free place.
  Values border(Values to, double part, double gives) const {
    Values from = free_place();
    for (int i = 0; i < 24; ++i) {
      const Values middle = between(from, to, 0.5);
      (is_near(middle, part, gives) ? to : from) = middle;
    }
    return to;
  }
  /// Inside and not intersecting, at any depth; or intersecting by some millimetres of motion. The
  /// last place tried if none is found.
  Values start(bool intersects) const {
    Values at;
    bool is = false;
    for (int i = 0; !is && i < 200; ++i) {
      const Values wrong = any(true, 0, 0);
      const double depth = intersects ? 0 : std::pow(real_between(random, 0.17, 0.98), 2);
      at = !intersects && random.below(2) == 0 ? any() : border(wrong, depth, 0);
      at = intersects ? step(at, wrong, real_between(random, 0, 1)) : at;
      is = intersects ? is_near(at, 0, 0) : is_near(at, 1, 0) && !is_near(at, 0, 0, 5);
    }
    return at;
  }
  static Values between(const Values& from, const Values& to, double part) {
    Values made = from;
    for (std::size_t i = 0; i < from.size(); ++i) {
      made[i] += static_cast<std::int32_t>(part * (double(to[i]) - from[i]));
    }
    return made;
  }
  /// A period's step.
  Values step(const Values& from, const Values& to, double speed) const {
    double periods = 1e-9;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const bool slides = robot.joints[model.variables[i]].type == JointType::prismatic;
      const double way = std::abs(double(to[i]) - from[i]) * unit_of(i);
      periods = std::max(periods, way / speed / (slides ? kSlide : kTurn));
    }
    return periods > 1 ? between(from, to, 1 / periods) : to;
  }

  const Robot& robot;
  Model model;
  Random& random;
  double cell = cell_of(robot);
  double rounding = robot.slack;  ///< less deviations
  std::vector<DrawnMesh> meshes;
  std::vector<bool> left_out;  ///< pairs that are nowhere found far beyond their stop distance
};

/// An arm that is sent and follows late, each command and each verdict judged.
struct Sent {
  Sent(const Drawn& of, const Values& start, std::uint32_t budget, double delay, Counts& counted)
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
    ++counts.commands;
    const Values before = std::exchange(now, wanted);
    if (obeys) {
      answer = guard.limit(wanted.data(), now.data(), work);
      REQUIRE(answer.status == Status::done);
      judge("limit", before, now, [&](std::size_t i) { return drawn.kept(i, floors[i]); });
    }
    for (std::uint16_t i = 0; i < floors.size(); ++i) {
      counts.raised += floors[i] > 0 && guard.floor(i) > floors[i] ? 1 : 0;
      floors[i] = std::max<double>(floors[i], guard.floor(i));
    }
    follow();
  }
  /// The robot follows, each joint in its own time, and its values are updated.
  void follow() {
    const Values before(late.begin(), late.end());
    for (std::size_t i = 0; i < now.size(); ++i) {
      late[i] += (now[i] - late[i]) / (lag * static_cast<double>(1 + i % 3));
    }
    const Values values(late.begin(), late.end());
    std::vector<double> seen;
    for (std::size_t i = 0; i < floors.size(); ++i) {
      const GuardPair& pair = state->pairs[i];
      const std::uint32_t own = (pair.seen & kOwn) != 0 ? pair.lower : 0;
      seen.push_back(std::min<double>(std::max(pair.seen & ~kOwn, own), drawn.limit(i, 1, 1)));
    }
    const GuardAnswer is = guard.update(values.data(), work);
    REQUIRE(is.status == Status::done);
    counts.leaving += is.verdict == Verdict::leaving ? 1 : 0;
    judge("update", before, values, [&](std::size_t i) {
      const RobotPair& pair = drawn.robot.pairs[i];
      const double floor = is_released(i) ? 0 : drawn.kept(i, seen[i]);
      return is.verdict == Verdict::free      ? pair.warn
             : is.verdict == Verdict::warn    ? pair.stop
             : is.verdict == Verdict::leaving ? std::min<double>(floor, pair.stop)
                                              : 0;
    });
  }
  /// Tests the end, and a few places of the box between. `kept(i)`: what a pair keeps.
  template <class Kept>
  void judge(const char* what, const Values& from, const Values& to, const Kept& kept) {
    const std::uint32_t places = from == to ? 1 : 2 + drawn.random.below(3);
    for (std::uint32_t place = 0; place < places; ++place) {
      Values at = to;
      for (std::size_t i = 0; place != 0 && i < at.size(); ++i) {
        const double parts[] = {0, 1, real_between(drawn.random, 0, 1)};
        const double way = drawn.random.one_of(parts) * (double(to[i]) - from[i]);
        at[i] = from[i] + static_cast<std::int32_t>(way);
      }
      const std::vector<Transform> frames = drawn.frames(at);
      for (std::size_t i = 0; i < floors.size(); ++i) {
        counts.checks += kept(i) > 0 ? 1 : 0;
        if (kept(i) > 0 && drawn.is_nearer(i, frames, kept(i)) && ++counts.unsound <= 5) {
          std::printf("unsound: %s, %s at %.5f mm, work %u, command %ld\n", what,
                      drawn.name_of(i).c_str(), kept(i) * drawn.cell / kFineOne * 1000, work,
                      counts.commands);
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
  const Drawn& drawn;
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
void send_anywhere(const Drawn& drawn, Counts& counts) {
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
  for (int i = 0; i < 150; ++i) {
    const bool turns = sent.now == target || random.below(50) == 0;
    target = turns ? Drawn::between(place, drawn.any(), reach) : target;
    sent.command(drawn.step(sent.now, target, speed));
  }
}

/// Sends an arm that is inside, or that intersects and is released, to free places until it is out.
void send_out(const Drawn& drawn, bool is_release, Counts& counts) {
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
    counts.periods.push_back(periods);
  } else {
    const std::uint16_t by = sent.answer.pair;
    std::printf("start %ld stays: limit's verdict %d, %s\n", counts.starts,
                int(sent.answer.verdict), by == kNoPair ? "no pair" : drawn.name_of(by).c_str());
  }
}

void send(const Drawn& drawn, long starts, long periods, Counts& counts) {
  for (long i = 0; i < starts; ++i) {
    send_out(drawn, false, counts);
    if (i % 5 == 0) {
      send_out(drawn, true, counts);
    }
  }
  for (const long end = counts.commands + periods; counts.commands < end;) {
    send_anywhere(drawn, counts);
  }
}

void check(const std::string& name, Counts& of) {
  std::sort(of.periods.begin(), of.periods.end());
  const std::size_t out = of.periods.size();
  std::printf("| %s | %ld | %ld | %zu | %ld | %ld | %ld of %ld | %ld | %ld | %ld |\n", name.c_str(),
              of.starts, of.first, out, out == 0 ? 0 : of.periods[out / 2],
              out == 0 ? 0 : of.periods.back(), of.released, of.releases, of.unsound, of.commands,
              of.checks);
  CHECK(of.unsound == 0);
}

}  // namespace

TEST_CASE("the way out: by force, no pair of an arm gets nearer than promised, and arms come out") {
  CAPTURE(test_seed());
  Random random = test_random();
  Counts all;
  for (int arms = 0; arms < rounds(16, 400); ++arms) {
    const FixedArm arm(any_guarded_arm(random, 3 + random.below(3), 5e-5));
    send(Drawn(arm.robot(), arm.model, random), 2, 600, all);
  }
  check("random arms", all);
  CHECK(2 * static_cast<long>(all.periods.size()) >= all.starts);
  CHECK(all.released > 0);
  CHECK(all.raised > 0);
  CHECK(all.leaving > 0);
  const char* const robot = setting("FLASHBVH_URDF");
  std::istringstream words(robot == nullptr ? "" : robot);
  std::vector<std::string> files(std::istream_iterator<std::string>(words), {});
  if (files.size() >= 2) {
    Warnings warnings;
    const RobotFile image(files[1]);
    const Packages packages = packages_of({files.begin() + 2, files.end()});
    const Drawn drawn(image.robot(), read_urdf(files[0], packages, "", warnings), random);
    for (std::size_t i = 0; i < drawn.left_out.size(); ++i) {
      if (drawn.left_out[i]) {
        std::printf("left out of the starts: %s\n", drawn.name_of(i).c_str());
      }
    }
    Counts counts;
    send(drawn, number_in("FLASHBVH_STARTS", 20), number_in("FLASHBVH_PERIODS", 20'000), counts);
    check(files[1], counts);
  }
}
