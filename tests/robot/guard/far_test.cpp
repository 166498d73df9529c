// Guards and motions of gantries, whose slides are far longer than the largest distance of a query.
// All axes and faces are parallel to the world's axes, so a formula gives the truth.
#include <array>

#include "flashbvh/robot/motion.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/oracles/float_distance.hpp"
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
  /// `half_edge`: of the cubes, in metres.
  explicit Gantry(double half_edge) : half(half_edge) { add_link(model, kNoJoint, cube()); }

  bake::SourceMesh cube() const { return box({-half, -half, -half}, {half, half, half}); }

  void add_slide(std::size_t axis, double range, bool has_link) {
    const std::size_t number = axes.size();
    const Transform fixed =
        number == 0 ? along(axis) : composed(inverse(along(axes.back())), along(axis));
    const std::size_t parent = number == 0 ? kNoJoint : number - 1;
    add_joint(model, parent, fixed, JointType::prismatic, -range, range);
    axes.push_back(axis);
    if (has_link) {
      add_link(model, number, cube());
    }
  }

  double half;
  Model model;
  std::vector<std::size_t> axes;
  std::vector<GuardedPair> pairs;
};

Gantry any_gantry(Random& random) {
  Gantry gantry(real_between(random, 0.01, 0.16));
  const std::size_t slides = 2 + random.below(4);
  for (std::size_t i = 0; i < slides; ++i) {
    const std::size_t axis = random.below(3);
    const double range = real_between(random, 0.1, 5.0 / static_cast<double>(slides));
    gantry.add_slide(axis, range, i + 1 == slides || random.below(2) == 0);
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

/// From the centre of a pair's first cube to that of its second, in metres.
Vector3 between_centres(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
                        const Values& values) {
  const auto centre_of = [&](std::size_t link) {
    const std::size_t last = gantry.model.links[link].joint;
    Vector3 at{};
    for (std::size_t i = 0; last != kNoJoint && i <= last; ++i) {
      at[gantry.axes[i]] += values[i] * arm.unit_of(i);
    }
    return at;
  };
  return minus(centre_of(pair.b), centre_of(pair.a));
}

/// The distance of two solid cubes, in 1/256 cell.
double distance_of(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
                   const Values& values) {
  Vector3 gap = between_centres(arm, gantry, pair, values);
  for (double& along_axis : gap) {
    along_axis = std::max(std::fabs(along_axis) - 2 * gantry.half, 0.0);
  }
  return std::sqrt(squared(gap)) * kFine;
}

/// Whether the truth contradicts a verdict of the period.
bool is_contradicted(const FixedArm& arm, const Gantry& gantry, const GuardAnswer& answer,
                     const Period& period, Random& random) {
  bool is = false;
  for (int moment = 0; !is && moment < 6; ++moment) {
    const Values values = period.at(moment, random);
    is = !holds(arm.robot(), answer, [&](const RobotPair& pair, std::uint32_t limit) {
      return distance_of(arm, gantry, pair, values) <= limit;
    });
  }
  return is;
}

/// Whether the spheres alone prove the pair free, beyond the distance of any query.
bool is_far(const FixedArm& arm, const Gantry& gantry, const RobotPair& pair,
            const Period& period) {
  // The baked sphere is up to 1 % larger than the smallest one; rounded up, both placed.
  const double radius = 1.01 * std::sqrt(3.0) * gantry.half * kFine + 512;
  const double apart = std::sqrt(squared(between_centres(arm, gantry, pair, period.at_end())));
  const double gap = apart * kFine - 2 * radius;
  const double travel = 1.02 * period.travel(arm, pair);  // the guard's levers are rounded up
  return gap > kMaxGuardDistance && gap - travel > pair.warn + arm.robot().slack;
}

constexpr std::uint32_t kBudgets[] = {1, 17, 100, UINT32_MAX, UINT32_MAX, UINT32_MAX};

}  // namespace

TEST_CASE(
    "two pairs that go farther in a period than any query's distance, metres apart, are free") {
  Gantry gantry(0.05);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gantry.add_slide(axis, 2, axis == 2);
  }
  gantry.add_slide(1, 0.5, true);
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
  Gantry gantry(0.05);
  gantry.add_slide(0, 2, true);
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
  long verdicts[6] = {};
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
        const bool is_of_far =
            answer.pair != kNoPair && is_far(arm, gantry, arm.robot().pairs[answer.pair], period);
        REQUIRE((answer.verdict == Verdict::free || !is_of_far));
        far += is_of_far ? 1 : 0;
      }
      ++verdicts[static_cast<int>(answer.verdict)];
      before = now;
    }
  });
  CAPTURE(verdicts[0], verdicts[1], verdicts[3], verdicts[4]);
  CHECK(verdicts[0] > 0);
  CHECK(verdicts[3] > 0);
  CHECK(verdicts[4] > 0);
  CHECK(far > 0);
}
