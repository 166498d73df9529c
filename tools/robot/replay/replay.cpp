#include "robot/replay/replay.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "flashbvh/robot/robot_float.hpp"
#include "robot/baked/fixed_robot.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::uint32_t kMostPairs = kMaxLinks * (kMaxLinks - 1) / 2;
/// Too large for a stack.
using AnyGuardState = GuardStateOf<kMaxJoints, kMostPairs, kMostPairs * kMaxJoints>;
using AnyMotionState = MotionStateOf<kMaxJoints, kMaxJoints>;

/// The coordinates of the variables, converted from floats as in firmware.
std::vector<JointCoordinate> coordinates_of(const Robot& robot, const float* floats) {
  std::vector<JointCoordinate> values(robot.variable_count);
  set_values(robot, floats, values.data());
  return values;
}

/// The values in radians and metres.
std::vector<double> lengths_of(const Robot& robot, const std::vector<JointCoordinate>& values) {
  std::vector<double> lengths(values.size());
  for (std::uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.shift == 0) {  // no mimic
      lengths[joint.variable] =
          values[joint.variable] * unit_of_coordinate(joint.type, cell_of(robot));
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

/// Takes the pair if it is nearer than the closest one so far.
void take_nearer(const Robot& robot, std::size_t period, std::uint16_t number, const Pose& pose,
                 std::optional<ClosestMoment>& closest) {
  const Mesh& a = robot.meshes[robot.pairs[number].a];
  const Mesh& b = robot.meshes[robot.pairs[number].b];
  if (closest && (closest->lower == 0 || !closer_than(a, b, pose, {closest->lower - 1}).yes)) {
    return;
  }
  const Clearance<std::uint16_t> found = distance(a, b, pose);
  if (found.status == Status::done && found.in_range &&
      (!closest || found.lower < closest->lower)) {
    closest = ClosestMoment{period, number, found.lower};
  }
}

}  // namespace

std::size_t kind_of(const GuardAnswer& answer) {
  return answer.status == Status::done ? static_cast<std::size_t>(answer.verdict) : kRefusedKind;
}

const char* outcome_name(MotionOutcome outcome) {
  constexpr const char* kNames[] = {"free", "hit", "close"};
  return kNames[static_cast<std::size_t>(outcome)];
}

bool is_free(const CertifiedMotion& motion) {
  return motion.answer.status == Status::done && motion.answer.outcome == MotionOutcome::free;
}

ReplaySummary summary_of(const std::vector<GuardAnswer>& answers) {
  ReplaySummary summary;
  std::vector<std::uint32_t> work;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::size_t kind = kind_of(answers[i]);
    if (summary.periods[kind]++ == 0) {
      summary.first[kind] = i;
    }
    if (summary.is_primed) {
      work.push_back(answers[i].work);
    } else if (kind != kRefusedKind) {
      summary.is_primed = true;
      summary.priming = answers[i].work;
    }
  }
  if (!work.empty()) {
    std::sort(work.begin(), work.end());
    summary.mean =
        std::accumulate(work.begin(), work.end(), 0.0) / static_cast<double>(work.size());
    summary.with_work = static_cast<double>(std::count_if(work.begin(), work.end(),
                                                          [](auto of) { return of != 0; })) /
                        static_cast<double>(work.size());
    summary.percentile_999 = work[work.size() - 1 - work.size() / 1000];
    summary.most = work.back();
  }
  return summary;
}

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

std::vector<GuardAnswer> replay_limited(const Robot& robot, Trajectory& trajectory,
                                        std::uint32_t work, std::vector<LimitAnswer>& limits) {
  const auto state = std::make_unique<AnyGuardState>();
  Guard guard(robot, *state);
  std::vector<GuardAnswer> answers;
  std::vector<JointCoordinate> granted;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const std::vector<JointCoordinate> wanted = coordinates_of(robot, trajectory.values(i));
    const bool is_first = granted.empty();
    GuardAnswer answer = {};
    if (is_first) {
      answer = guard.prime(wanted.data());
      granted = answer.status == Status::done ? wanted : granted;
    }
    LimitAnswer limit = {answer.status, LimitVerdict::refused, 0, kNoPair, kNoPair, 0, 0, 0};
    if (!granted.empty()) {
      limit = guard.limit(wanted.data(), granted.data(), is_first ? kAllWork : work);
    }
    if (!is_first && limit.status == Status::done) {
      answer = guard.update(granted.data(), work);
    } else if (!is_first) {
      answer = {limit.status, Verdict::refused, kNoPair, 0, 0};
    }
    answer.work += limit.work;
    answers.push_back(answer);
    limits.push_back(limit);
    const std::vector<double> lengths =
        granted.empty() ? std::vector<double>() : lengths_of(robot, granted);
    std::copy(
        lengths.begin(), lengths.end(),
        trajectory.all_values.begin() + static_cast<std::ptrdiff_t>(i * trajectory.variables));
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
  PosedPairs posed(robot);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (!posed.take(trajectory.values(i))) {
      continue;
    }
    for (std::uint16_t pair = 0; pair < robot.pair_count; ++pair) {
      take_nearer(robot, i, pair, posed.pose(robot.pairs[pair]), closest);
    }
  }
  return closest;
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

bool PosedPairs::take(const float* floats) {
  if (set_coordinates(robot_, coordinates_of(robot_, floats).data(), coordinates_.data()) !=
      Status::done) {
    return false;
  }
  set_frames(robot_, coordinates_.data(), frames_.data());
  return true;
}

std::optional<std::uint32_t> PosedPairs::distance_of(std::uint16_t pair) {
  const RobotPair& links = robot_.pairs[pair];
  const Clearance<std::uint16_t> found =
      distance(robot_.meshes[links.a], robot_.meshes[links.b], pose(links), nearest_[pair]);
  if (found.status != Status::done || !found.in_range) {
    return std::nullopt;
  }
  nearest_[pair] = found.witness;
  return found.lower;
}

}  // namespace flashbvh::tool
