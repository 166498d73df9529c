// The travel of links, computed from levers, against exact distances.
#include "robot/levers.hpp"

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "robot/coordinate.hpp"
#include "support/arms/fixed_arm.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

struct Posed {
  Posed(const Robot& of, const std::vector<JointCoordinate>& coordinates)
      : robot(of), frames(of.joint_count) {
    set_frames(robot, coordinates.data(), frames.data());
  }
  const Frame& frame_of(const RobotLink& link) const {
    return detail::frame_of(frames.data(), link.joint);
  }
  Clearance<std::uint16_t> clearance(const RobotPair& pair) const {
    const Pose pose = relative_pose(frame_of(robot.links[pair.a]), frame_of(robot.links[pair.b]));
    return clearance_of(robot.meshes[pair.a], robot.meshes[pair.b], pose);
  }
  static Clearance<std::uint16_t> clearance_of(const Mesh& a, const Mesh& b, const Pose& pose) {
    ClearanceQuery query(a, b, pose);
    (void)query.run(UINT32_MAX);
    return query.result();
  }

  const Robot& robot;
  std::vector<Frame> frames;
};

/// The travel from `from` to `to`, by levers at `from`.
std::uint32_t travel_between(const RobotPair& pair, const Posed& at,
                             const std::vector<JointCoordinate>& from,
                             const std::vector<JointCoordinate>& to) {
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
double farthest_from_axis(const Posed& at, std::uint32_t joint, std::uint8_t number) {
  const RobotLink& link = at.robot.links[number];
  const Mesh& mesh = at.robot.meshes[number];
  const Frame& of_link = at.frame_of(link);
  const Frame& of_joint = at.frames[joint];
  double most = 0;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    const Vertex& v = mesh.vertices[i];
    const double own[3] = {1.0 * mesh.origin[0] + v.x, 1.0 * mesh.origin[1] + v.y,
                           1.0 * mesh.origin[2] + v.z};
    double along = 0;
    double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      double off = 1.0 * (of_link.translation[axis] - of_joint.translation[axis]) / kFrameCell;
      for (int k = 0; k < 3; ++k) {
        off += std::ldexp(of_link.rotation[axis][k] * own[k], -30);
      }
      along += std::ldexp(of_joint.rotation[axis][2] * off, -30);
      squared += off * off;
    }
    most = std::max(most, std::sqrt(std::max(0.0, squared - along * along)));
  }
  return most;
}

/// The travel of the farthest vertices on a straight joint motion, in small steps, in 1/256 cell.
double way_of_vertices(const RobotPair& pair, const Robot& robot,
                       const std::vector<JointCoordinate>& from,
                       const std::vector<JointCoordinate>& to) {
  constexpr int kSteps = 24;
  double sum = 0;
  for (int step = 0; step < kSteps; ++step) {
    std::vector<JointCoordinate> middle(from);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double way = 1.0 * to[i] - from[i];
      middle[i] = static_cast<JointCoordinate>(from[i] + way * (step + 0.5) / kSteps);
    }
    const Posed at(robot, middle);
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
    to[i] =
        arm.is_free(i)
            ? static_cast<JointCoordinate>(at)
            : static_cast<JointCoordinate>(std::clamp<std::int64_t>(at, joint.lower, joint.upper));
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
    std::vector<JointCoordinate> from(robot.joint_count);
    std::vector<JointCoordinate> to(robot.joint_count);
    for (int i = 0; i < 20; ++i) {
      const Values values = arm.any_values(random);
      REQUIRE(set_coordinates(robot, values.data(), from.data()) == Status::done);
      if (set_coordinates(robot, near_values(arm, values, random).data(), to.data()) !=
          Status::done) {
        continue;  // over a turn apart
      }
      const Posed before(robot, from);
      const Posed after(robot, to);
      for (std::uint32_t j = 0; j < robot.pair_count; ++j) {
        const RobotPair& pair = robot.pairs[j];
        const std::uint32_t travel = travel_between(pair, before, from, to);
        detail::Travel sum;
        detail::for_each_between(robot, pair, [&](std::uint32_t joint, std::uint32_t reach) {
          sum.add_short(reach, detail::apart(from[joint], to[joint]));
        });
        const std::uint32_t by_reaches = sum.fine();
        const Clearance<std::uint16_t> was = before.clearance(pair);
        const Clearance<std::uint16_t> is = after.clearance(pair);
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
  CHECK(shorter > 100);
}
