#include "robot/replay.hpp"

#include <cmath>
#include <cstring>
#include <memory>

#include "flashbvh/robot/robot_float.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::uint32_t kMostPairs = kMaxLinks * (kMaxLinks - 1) / 2;
/// Too large for a stack.
using AnyGuardState = GuardStateOf<kMaxJoints, kMostPairs, kMostPairs * kMaxJoints>;
using AnyMotionState = MotionStateOf<kMaxJoints, kMaxJoints>;

std::vector<JointCoordinate> coordinates_of(const Robot& robot, const float* floats) {
  std::vector<JointCoordinate> values(robot.variable_count);
  set_values(robot, floats, values.data());
  return values;
}

double cell_of(const Robot& robot) {
  double cell = 0;
  std::memcpy(&cell, &robot.cell_bits, sizeof cell);
  return cell;
}

/// In radians and metres.
std::vector<double> lengths_of(const Robot& robot, const std::vector<JointCoordinate>& values) {
  constexpr double kTwoPi = 6.283185307179586;
  std::vector<double> lengths(values.size());
  for (std::uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.shift == 0) {  // no mimic
      lengths[joint.variable] =
          values[joint.variable] *
          (joint.type == JointType::prismatic ? cell_of(robot) / kFrameCell : kTwoPi / kFullTurn);
    }
  }
  return lengths;
}

CertifiedMotion certified(const Robot& robot, AnyMotionState& state, const float* from,
                          const float* to) {
  MotionQuery query(robot, state);
  const Status status =
      query.start(coordinates_of(robot, from).data(), coordinates_of(robot, to).data());
  if (status != Status::done) {
    return {{status, MotionOutcome::close, 0, {}, 0, 0}, 0, {}};
  }
  CertifiedMotion motion = {query.run(UINT32_MAX), 0, {}};
  while (motion.answer.status == Status::suspended) {
    motion.answer = query.run(UINT32_MAX);
  }
  std::vector<JointCoordinate> values(robot.variable_count);
  query.set_values(motion.answer.numerator, motion.answer.level, values.data());
  motion.part = std::ldexp(motion.answer.numerator, -motion.answer.level);
  motion.values = lengths_of(robot, values);
  return motion;
}

/// The poses of pairs of links in a period.
class Configuration {
 public:
  explicit Configuration(const Robot& robot)
      : robot_(robot), coordinates_(robot.joint_count), frames_(robot.joint_count) {}

  /// False if firmware refuses the values.
  bool take(const float* floats) {
    if (set_coordinates(robot_, coordinates_of(robot_, floats).data(), coordinates_.data()) !=
        Status::done) {
      return false;
    }
    set_frames(robot_, coordinates_.data(), frames_.data());
    return true;
  }

  Pose pose(const RobotPair& pair) const {
    return relative_pose(frame_of(pair.a), frame_of(pair.b));
  }
  Pose pose(std::uint8_t link) const { return relative_pose(kIdentityFrame, frame_of(link)); }

 private:
  const flashbvh::Frame& frame_of(std::uint8_t link) const {
    const std::uint8_t joint = robot_.links[link].joint;
    return joint == kBase ? kIdentityFrame : frames_[joint];
  }

  const Robot& robot_;
  std::vector<JointCoordinate> coordinates_;
  std::vector<flashbvh::Frame> frames_;
};

/// The pair, if it is nearer than the closest one by now.
void take_nearer(const Robot& robot, std::size_t period, std::uint16_t number, const Pose& pose,
                 std::optional<ClosestMoment>& closest) {
  const PostMesh& a = robot.meshes[robot.pairs[number].a];
  const PostMesh& b = robot.meshes[robot.pairs[number].b];
  if (closest) {
    const std::uint32_t least = closest->clearance.lower;
    if (least == 0 || !closer_than(a, b, pose, least - 1).yes) {
      return;
    }
  }
  const Clearance<std::uint16_t> found = distance(a, b, pose);
  if (found.status == Status::done && found.in_range &&
      (!closest || found.lower < closest->clearance.lower)) {
    closest = ClosestMoment{period, number, pose, found};
  }
}

}  // namespace

std::vector<GuardAnswer> replay(const Robot& robot, const Trajectory& trajectory,
                                std::uint32_t work) {
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(robot, *state);
  std::vector<GuardAnswer> answers;
  bool is_primed = false;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::vector<JointCoordinate> values = coordinates_of(robot, trajectory.values(i));
    answers.push_back(guard.update(values.data(), is_primed ? work : kAllWork));
    is_primed = is_primed || answers.back().status == Status::done;
  }
  return answers;
}

std::vector<CertifiedMotion> certify(const Robot& robot, const Trajectory& trajectory) {
  const auto state = std::make_unique<AnyMotionState>();
  std::vector<CertifiedMotion> motions;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    motions.push_back(certified(robot, *state, trajectory.values(i - 1), trajectory.values(i)));
  }
  return motions;
}

std::optional<ClosestMoment> closest_moment(const Robot& robot, const Trajectory& trajectory) {
  std::optional<ClosestMoment> closest;
  Configuration configuration(robot);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!configuration.take(trajectory.values(i))) {
      continue;
    }
    for (std::uint16_t pair = 0; pair < robot.pair_count; ++pair) {
      take_nearer(robot, i, pair, configuration.pose(robot.pairs[pair]), closest);
    }
  }
  return closest;
}

std::vector<std::vector<std::optional<double>>> distances_over(const Robot& robot,
                                                               const Trajectory& trajectory,
                                                               std::size_t step) {
  std::vector<std::vector<std::optional<double>>> distances(robot.pair_count);
  std::vector<Witness<std::uint16_t>> nearest(robot.pair_count);
  Configuration configuration(robot);
  for (std::size_t i = 0; i < trajectory.size(); i += step) {
    const bool is_accepted = configuration.take(trajectory.values(i));
    for (std::size_t pair = 0; pair < distances.size(); ++pair) {
      distances[pair].emplace_back();
      if (!is_accepted) {
        continue;
      }
      const RobotPair& links = robot.pairs[pair];
      const Clearance<std::uint16_t> found = distance(robot.meshes[links.a], robot.meshes[links.b],
                                                      configuration.pose(links), nearest[pair]);
      if (found.status == Status::done && found.in_range) {
        nearest[pair] = found.witness;
        distances[pair].back() = found.lower * cell_of(robot) / kFineOne;
      }
    }
  }
  return distances;
}

std::vector<Pose> link_poses(const Robot& robot, const float* values) {
  Configuration configuration(robot);
  (void)configuration.take(values);
  std::vector<Pose> poses;
  for (std::uint8_t link = 0; link < robot.link_count; ++link) {
    poses.push_back(configuration.pose(link));
  }
  return poses;
}

std::size_t refused_joint(const Robot& robot, const float* values) {
  const std::vector<JointCoordinate> coordinates = coordinates_of(robot, values);
  std::vector<JointCoordinate> made(robot.joint_count);
  Robot first_joints = robot;
  first_joints.joint_count = 1;
  while (set_coordinates(first_joints, coordinates.data(), made.data()) == Status::done) {
    ++first_joints.joint_count;
  }
  return first_joints.joint_count - 1u;
}

}  // namespace flashbvh::tool
