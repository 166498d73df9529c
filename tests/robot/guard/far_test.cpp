// Guards and motions of gantries, whose slides are far longer than the largest distance of a query.
// All axes and faces are parallel to the world's axes, so a formula gives the truth.
#include <array>

#include "flashbvh/robot/motion.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// kMaxGuardDistance is 0.33 m.
constexpr double kCell = 1e-5;
constexpr double kFine = 256 / kCell;

/// The frame that turns a slide along an axis of the world.
const Transform& along(std::size_t axis) {
  static const std::array<Transform, 3> turns = {
      composed(turned(0, kPi / 2), turned(1, kPi / 2)),  // z to x, x to y, y to z
      composed(turned(1, kPi / 2), turned(0, kPi / 2)),
      Transform(),
  };
  return turns[axis];
}

/// A chain of slides, some of which carry a cube, and one fixed cube.
struct Gantry {
  Model model;
  std::vector<std::size_t> axes;
  std::vector<std::size_t> slide_of;  ///< for each link but the first
  std::vector<GuardedPair> pairs;
  double half = 0;  ///< half an edge of the cubes
};

bake::SourceMesh cube(double half) {
  return box({-half, -half, -half}, {half, half, half});
}

void add_slide(Gantry& gantry, std::size_t axis, double range, bool has_link) {
  const std::size_t number = gantry.axes.size();
  const Transform fixed =
      number == 0 ? along(axis) : composed(inverse(along(gantry.axes.back())), along(axis));
  add_joint(gantry.model, number == 0 ? kNoJoint : number - 1, fixed, JointType::prismatic, -range,
            range);
  gantry.axes.push_back(axis);
  if (has_link) {
    add_link(gantry.model, number, cube(gantry.half));
    gantry.slide_of.push_back(number);
  }
}

Gantry any_gantry(Random& random) {
  Gantry gantry;
  gantry.half = real_between(random, 0.01, 0.16);
  add_link(gantry.model, kNoJoint, cube(gantry.half));
  const std::size_t slides = 2 + random.below(4);
  for (std::size_t i = 0; i < slides; ++i) {
    add_slide(gantry, random.below(3), real_between(random, 0.1, 5.0 / static_cast<double>(slides)),
              i + 1 == slides || random.below(2) == 0);
  }
  const double stop = real_between(random, 0, 0.1);
  const double warn = stop + real_between(random, 0, 0.1);
  for (std::size_t b = 1; b < gantry.model.links.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      gantry.pairs.push_back({a, b, stop, warn});
    }
  }
  return gantry;
}

using Point = std::array<double, 3>;

/// The centre of a link's cube, in metres.
Point centre_of(const FixedArm& arm, const Gantry& gantry, std::size_t link, const Values& values) {
  Point at{};
  for (std::size_t i = 0; link != 0 && i <= gantry.slide_of[link - 1]; ++i) {
    at[gantry.axes[i]] += values[i] * arm.unit_of(i);
  }
  return at;
}

double centres_apart(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
                     const Values& values) {
  const Point a = centre_of(arm, gantry, pair.a, values);
  const Point b = centre_of(arm, gantry, pair.b, values);
  return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

/// The distance of two solid cubes, in 1/256 cell.
double distance_of(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
                   const Values& values) {
  const Point a = centre_of(arm, gantry, pair.a, values);
  const Point b = centre_of(arm, gantry, pair.b, values);
  Point gap{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max(std::fabs(b[axis] - a[axis]) - 2 * gantry.half, 0.0);
  }
  return std::hypot(gap[0], gap[1], gap[2]) * kFine;
}

/// Whether the truth contradicts a verdict of the period.
bool is_contradicted(const FixedArm& arm, const Gantry& gantry, const GuardAnswer& answer,
                     const Period& period, Random& random) {
  for (int moment = 0; moment < 6; ++moment) {
    const Values values = period.at(moment, random);
    for (std::uint16_t i = 0; i < arm.robot().pair_count; ++i) {
      const RobotPair& pair = arm.robot().pairs[i];
      const double apart = distance_of(arm, gantry, pair, values);
      if ((answer.verdict == Verdict::free && apart <= pair.warn) ||
          (answer.verdict == Verdict::warn && apart <= pair.stop) ||
          (i == answer.pair && apart < answer.distance)) {
        return true;
      }
    }
  }
  return false;
}

/// Whether the spheres alone prove the pair free, beyond the distance of any query.
bool is_far(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
            const Period& period) {
  const double radius = std::sqrt(3.0) * gantry.half * kFine + 512;  // rounded up, both placed
  const double gap = centres_apart(arm, gantry, pair, period.at_end()) * kFine - 2 * radius;
  return gap > kMaxGuardDistance && gap - period.travel(arm, pair) > pair.warn + arm.robot().slack;
}

constexpr std::uint32_t kBudgets[] = {1, 17, 100, UINT32_MAX, UINT32_MAX, UINT32_MAX};

}  // namespace

TEST_CASE(
    "two pairs that go farther in a period than any query's distance, metres apart, are free") {
  Gantry gantry;
  gantry.half = 0.05;
  add_link(gantry.model, kNoJoint, cube(gantry.half));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add_slide(gantry, axis, 2, axis == 2);
  }
  add_slide(gantry, 1, 0.5, true);
  gantry.pairs = {{0, 1, 0.005, 0.03}, {0, 2, 0.005, 0.03}, {1, 2, 0.005, 0.03}};
  const FixedArm arm(gantry.model, 1.3e-5, gantry.pairs);
  const double unit = arm.unit_of(0);
  const auto values = [&](double x, double w) {
    Values made;
    for (const double length : {x, 1.0, 1.0, w}) {
      made.push_back(static_cast<JointCoordinate>(std::lround(length / unit)));
    }
    return made;
  };
  AnyGuardState state;
  Guard guard(arm.robot(), state);
  REQUIRE(guard.prime(values(1, 0.2).data()).verdict == Verdict::free);
  for (const std::uint32_t work : {UINT32_MAX, 100u}) {
    for (const double x : {1.5, 1.0, 0.5, 1.0}) {
      CAPTURE(work, x);
      const GuardAnswer answer = guard.update(values(x, 0.2).data(), work);
      CHECK(answer.verdict == Verdict::free);
      CHECK(answer.distance > answer.work);  // it is not 0
    }
  }
}

TEST_CASE("what was measured where a period ends is known in the next, however far it went") {
  Gantry gantry;
  gantry.half = 0.05;
  add_link(gantry.model, kNoJoint, cube(gantry.half));
  add_slide(gantry, 0, 2, true);
  const FixedArm arm(gantry.model, kCell, {{0, 1, 0.005, 0.03}});
  AnyGuardState state;
  Guard guard(arm.robot(), state);
  const auto at = [&](double x) { return static_cast<JointCoordinate>(x / arm.unit_of(0)); };
  const JointCoordinate left = at(-0.3);
  const JointCoordinate right = at(0.3);
  REQUIRE(guard.prime(&left).verdict == Verdict::free);
  CHECK(guard.update(&right, UINT32_MAX).verdict == Verdict::stop);  // passes through
  const GuardAnswer standing = guard.update(&right, 0);
  CHECK(standing.verdict == Verdict::free);
  CHECK(standing.distance > 0.09 * kFine);
  // If the remaining distance is too small and there is no work to measure, it is reported.
  const JointCoordinate nearer = right - at((standing.distance / kFine) - 0.004);
  const GuardAnswer unknown = guard.update(&nearer, 0);
  CHECK(unknown.verdict == Verdict::not_yet_known);
  CHECK(unknown.distance > 0.003 * kFine);
  CHECK(unknown.distance <= 0.005 * kFine);
}

TEST_CASE("gantries that jump anywhere: no call fails to end, and no verdict is contradicted") {
  long verdicts[5] = {};
  long far = 0;
  for_rounds(rounds(40, 200), [&](Random& random, int) {
    const Gantry gantry = any_gantry(random);
    const FixedArm arm(gantry.model, kCell, gantry.pairs);
    const auto state = std::make_unique<AnyGuardState>();
    Guard guard(arm.robot(), *state);
    Values before = arm.any_values(random);
    (void)guard.prime(before.data());
    for (int i = 0; i < 40; ++i) {
      CAPTURE(i);
      Values now = random.below(4) == 0 ? before : arm.any_values(random);
      for (std::size_t v = 0; v < now.size(); ++v) {
        now[v] = random.below(3) == 0 ? before[v] : now[v];
      }
      const std::uint32_t work = kBudgets[random.below(6)];
      const GuardAnswer answer = guard.update(now.data(), work);
      const Period period(arm, before, now);
      CAPTURE(static_cast<int>(answer.verdict), answer.pair, answer.distance, work);
      REQUIRE(answer.status == Status::done);
      REQUIRE_FALSE(is_contradicted(arm, gantry, answer, period, random));
      if (work == UINT32_MAX) {
        REQUIRE(answer.verdict != Verdict::not_yet_known);
        if (answer.verdict != Verdict::free) {
          REQUIRE_FALSE(is_far(arm, gantry, arm.robot().pairs[answer.pair], period));
        }
        far +=
            answer.pair != kNoPair && is_far(arm, gantry, arm.robot().pairs[answer.pair], period);
      }
      ++verdicts[static_cast<int>(answer.verdict)];
      before = now;
    }
  });
  CAPTURE(verdicts[0], verdicts[1], verdicts[2], verdicts[3]);
  CHECK(verdicts[0] > 0);
  CHECK(verdicts[2] > 0);
  CHECK(verdicts[3] > 0);
  CHECK(far > 0);
}
