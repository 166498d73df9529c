// The travel of links, computed from levers, against exact distances.
#include "robot/levers.hpp"

#include "flashbvh/clearance.hpp"
#include "robot/coordinate.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

Clearance<std::uint16_t> clearance(const PlacedLinks& at, const RobotPair& pair) {
  return distance(at.robot.meshes[pair.a], at.robot.meshes[pair.b], at.pose(pair.a, pair.b));
}

/// The travel from `from` to `to`, by levers at `from`.
std::uint32_t travel_between(const RobotPair& pair, const PlacedLinks& at, const Values& from,
                             const Values& to) {
  std::vector<std::uint8_t> shares(at.robot.joint_count);
  detail::set_shares(at.robot, pair, at.frames.data(), shares.data());
  detail::LeverTravel travel;
  const std::uint8_t* share = shares.data();
  detail::for_each_between(at.robot, pair, [&](std::uint32_t joint, std::uint32_t reach) {
    travel.add(at.robot.joints[joint], reach, *share++, detail::apart(from[joint], to[joint]));
  });
  return travel.fine();
}

/// The distance of the link's farthest vertex from the joint's axis, in cells.
double farthest_from_axis(const PlacedLinks& at, std::uint32_t joint, std::uint8_t link) {
  const Transform seen =
      composed(inverse(transform_of(at.frames[joint])), transform_of(at.frame_of(link)));
  double most = 0;
  for (const Vector3& vertex : vertices_of(at.robot.meshes[link])) {
    const Vector3 p = placed(seen, vertex);
    most = std::max(most, std::hypot(p[0], p[1]));
  }
  return most;
}

/// The travel of the farthest vertices on a straight joint motion, in small steps, in 1/256 cell.
double way_of_vertices(const RobotPair& pair, const Robot& robot, const Values& from,
                       const Values& to) {
  constexpr int kSteps = 24;
  double sum = 0;
  for (int step = 0; step < kSteps; ++step) {
    Values middle(from);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double way = 1.0 * to[i] - from[i];
      middle[i] = static_cast<JointCoordinate>(from[i] + way * (step + 0.5) / kSteps);
    }
    const PlacedLinks at(robot, middle);
    std::uint32_t passed = 0;
    detail::for_each_between(robot, pair, [&](std::uint32_t number, std::uint32_t reach) {
      const RobotJoint& joint = robot.joints[number];
      const double by = 1.0 * detail::apart(from[number], to[number]) / kSteps;
      const bool is_of_a = passed++ < pair.joints_a;
      const bool is_innermost =
          passed == pair.joints_a + pair.joints_b && (pair.joints_a == 0 || pair.joints_b == 0);
      if (joint.type == JointType::prismatic || joint.type == JointType::fixed) {
        sum += std::ldexp(by * reach, -kReachBits);
        return;
      }
      double lever = farthest_from_axis(at, number, is_of_a ? pair.a : pair.b);
      if (is_innermost) {
        lever = std::min(lever, farthest_from_axis(at, number, is_of_a ? pair.b : pair.a));
      }
      sum += 256 * lever * by * 2 * kPi / kFullTurn;
    });
  }
  return sum;
}

/// Moves each value by up to 1/2 to 2^-16 turn, or that part of its range, within the limits.
Values near_values(const FixedArm& arm, const Values& from, Random& random) {
  Values to = from;
  const std::int32_t most = kFullTurn >> (1 + random.below(16));
  for (std::size_t i = 0; i < to.size(); ++i) {
    const RobotJoint& joint = arm.joint_of(i);
    const std::int64_t at = std::int64_t{to[i]} + random.between(-most, most);
    to[i] = static_cast<JointCoordinate>(
        arm.is_free(i) ? at : std::clamp<std::int64_t>(at, joint.lower, joint.upper));
  }
  return to;
}

}  // namespace

TEST_CASE("a lever is at least what it was made of, and at most its reach") {
  Random random = test_random();
  for (int i = 0; i < 100000; ++i) {
    const auto reach = static_cast<std::uint32_t>(random.next()) >> random.below(24);
    const auto share = static_cast<std::uint8_t>(random.below(256));
    const std::uint64_t lever = detail::lever_of(reach, share);
    CAPTURE(reach, share, lever);
    REQUIRE(lever <= reach);
    REQUIRE(lever >= std::uint64_t{reach >> 8} * (share + 1u));
  }
  REQUIRE(detail::lever_of(UINT32_MAX, detail::kWholeReach) == UINT32_MAX);
}

TEST_CASE("no links come nearer to each other than levers say, often less than reaches do") {
  long nearer = 0;
  long shorter = 0;
  for_rounds(rounds(20, 600), [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(4), 1e-3);
    const Robot& robot = arm.robot();
    for (int i = 0; i < 20; ++i) {
      const Values values = arm.any_values(random);
      const Values from = coordinates_of(robot, values);
      const Values to = coordinates_of(robot, near_values(arm, values, random));
      REQUIRE_FALSE(from.empty());
      if (to.empty()) {
        continue;  // over a turn apart
      }
      const PlacedLinks before(robot, from);
      const PlacedLinks after(robot, to);
      for (std::uint32_t j = 0; j < robot.pair_count; ++j) {
        const RobotPair& pair = robot.pairs[j];
        const std::uint32_t travel = travel_between(pair, before, from, to);
        detail::Travel sum;
        detail::for_each_between(robot, pair, [&](std::uint32_t joint, std::uint32_t reach) {
          sum.add_short(reach, detail::apart(from[joint], to[joint]));
        });
        const std::uint32_t by_reaches = sum.fine();
        const Clearance<std::uint16_t> was = clearance(before, pair);
        const Clearance<std::uint16_t> is = clearance(after, pair);
        if (was.status != Status::done || is.status != Status::done || !is.in_range) {
          continue;
        }
        CAPTURE(j, was.lower, is.upper, travel, by_reaches, robot.slack);
        REQUIRE(std::int64_t{is.upper} + travel + 2 * robot.slack >= was.lower);
        REQUIRE(travel <= by_reaches);
        const double truth = way_of_vertices(pair, robot, from, to);
        CAPTURE(truth);
        REQUIRE(travel >= 0.9999 * truth);
        nearer += is.upper < was.lower ? 1 : 0;
        shorter += travel < by_reaches / 8 * 7 ? 1 : 0;
      }
    }
  });
  CAPTURE(nearer, shorter);
  CHECK(nearer > 100);
  CHECK(shorter > nearer / 8);
}
