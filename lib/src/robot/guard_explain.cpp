// The guard: reports where two links are nearest, and each joint's effect on their distance.
#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/robot/guard.hpp"
#include "guard_parts.hpp"

namespace flashbvh {
namespace {

constexpr int kDropped = kFrameBits - 8;  // to 1/256 cell

int64_t rounded(int64_t value, int bits) {
  return (value + (int64_t{1} << (bits - 1))) >> bits;
}

/// Product of a rotation's row and a vector with components of up to 2^31.
int64_t turned(const int32_t (&row)[3], const int64_t (&v)[3]) {
  return rounded(row[0] * v[0], 30) + rounded(row[1] * v[1], 30) + rounded(row[2] * v[2], 30);
}

/// Transforms a point, in 1/256 cell, to the base's frame.
FinePoint in_base(const Frame& frame, const FinePoint& p) {
  const int64_t v[3] = {p.x, p.y, p.z};
  const auto along = [&](int axis) {
    return turned(frame.rotation[axis], v) + rounded(frame.translation[axis], kDropped);
  };
  return {along(0), along(1), along(2)};
}

UnitVector in_base(const Frame& frame, const UnitVector& d) {
  const int64_t v[3] = {d.x, d.y, d.z};
  const auto along = [&](int axis) {
    return static_cast<int32_t>(turned(frame.rotation[axis], v));
  };
  return {along(0), along(1), along(2)};
}

/// Motion of the point along the direction per unit of the joint's coordinate, in 2^-kReachBits of
/// 1/256 cell.
int64_t way_along(const RobotJoint& joint, const Frame& frame, const FinePoint& point,
                  const UnitVector& along) {
  const int64_t axis[3] = {frame.rotation[0][2], frame.rotation[1][2], frame.rotation[2][2]};
  const int32_t direction[3] = {along.x, along.y, along.z};
  if (joint.type == JointType::prismatic) {
    return rounded(turned(direction, axis), 30 - (kReachBits - kDropped));
  }
  const int64_t from_axis[3] = {point.x - rounded(frame.translation[0], kDropped),
                                point.y - rounded(frame.translation[1], kDropped),
                                point.z - rounded(frame.translation[2], kDropped)};
  int64_t velocity[3];
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    velocity[i] = rounded(axis[j] * from_axis[k] - axis[k] * from_axis[j], 30);
  }
  constexpr int64_t quarter_circle = 102944;  // pi/2 in 2^-16: 2 pi 2^(kReachBits - kTurnBits)
  return rounded(quarter_circle * turned(direction, velocity), 16);
}

constexpr int32_t clamped(int64_t value) {
  return static_cast<int32_t>(value > INT32_MAX    ? INT32_MAX
                              : value < -INT32_MAX ? -INT32_MAX
                                                   : value);
}

}  // namespace

PairDetail Guard::explain(uint16_t i, int32_t* changes) {
  PairDetail detail{};
  detail.variable = kNoVariable;
  detail.status = refusal();
  if (!has_values() || i >= robot_->pair_count) {
    return detail;
  }
  const RobotPair& pair = robot_->pairs[i];
  make_frames();
  const Pose pose = pose_of(pair);
  detail.status = pose.status();
  if (pose.status() != Status::done) {
    return detail;
  }
  const Witness<uint16_t>& witness = pairs_[i].witness;
  Triangle a;
  Triangle b;
  if (!place_witness(i, witness, pose, a, b)) {
    detail.status = Status::distance_out_of_range;
    return detail;
  }
  detail.witness = witness;
  detail.triangles = {robot_->meshes[pair.a].triangle_ids[witness.a],
                      robot_->meshes[pair.b].triangle_ids[witness.b]};
  const Frame& frame_a = detail::frame_of(frames_, robot_->links[pair.a].joint);
  detail.nearest = nearest_points_of(a, b);
  detail.nearest.point_a = in_base(frame_a, detail.nearest.point_a);
  detail.nearest.point_b = in_base(frame_a, detail.nearest.point_b);
  detail.nearest.direction = in_base(frame_a, detail.nearest.direction);
  int64_t nearer = 0;
  int32_t most = 0;
  for (uint8_t variable = 0; variable < robot_->variable_count; ++variable) {
    const Share share = share_of(pair, variable, detail.nearest);
    changes[variable] = share.change;
    const int32_t size = share.change < 0 ? -share.change : share.change;
    if (share.way < nearer || (nearer == 0 && size > most)) {
      nearer = share.way < nearer ? share.way : nearer;
      most = size;
      detail.variable = variable;
    }
  }
  return detail;
}

/// The variable's effect on the distance of the two nearest points.
Guard::Share Guard::share_of(const RobotPair& pair, uint8_t variable,
                             const NearestPoints& nearest) const {
  int64_t change = 0;
  int64_t way = 0;
  uint32_t passed = 0;
  detail::for_each_between(*robot_, pair, [&](uint32_t number, uint32_t) {
    const bool moves_a = passed++ < pair.joints_a;
    const RobotJoint& joint = robot_->joints[number];
    if (joint.type == JointType::fixed || joint.variable != variable) {
      return;
    }
    const FinePoint& point = moves_a ? nearest.point_a : nearest.point_b;
    const int64_t along = way_along(joint, frames_[number], point, nearest.direction);
    const int64_t apart = moves_a ? -along : along;
    change += joint.shift == 0 ? apart : (apart * joint.multiplier) >> joint.shift;
    way += apart * step_[number];
  });
  return {clamped(change), way};
}

}  // namespace flashbvh
