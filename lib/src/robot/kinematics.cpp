// Forward kinematics, in integers with 64-bit products.
#include "flashbvh/robot/kinematics.hpp"

#include "../lattice/fixed_point.hpp"
#include "../lattice/sine.hpp"
#include "coordinate.hpp"

namespace flashbvh {
namespace {

using detail::fixed_product;
using detail::fixed_rounded;
using detail::sine_cosine;
using detail::SineCosine;

/// Turns a frame about its own z axis.
void turn(Frame& frame, JointCoordinate coordinate) {
  const SineCosine at = sine_cosine(static_cast<uint32_t>(coordinate) << (32 - detail::kTurnBits));
  for (auto& row : frame.rotation) {
    const int32_t x = row[0];
    const int32_t y = row[1];
    row[0] = fixed_rounded(fixed_product(x, at.cosine) + fixed_product(y, at.sine));
    row[1] = fixed_rounded(fixed_product(y, at.cosine) - fixed_product(x, at.sine));
  }
}

/// Moves a frame along its own z axis.
void slide(Frame& frame, JointCoordinate coordinate) {
  for (int i = 0; i < 3; ++i) {
    frame.translation[i] += fixed_rounded(fixed_product(frame.rotation[i][2], coordinate));
  }
}

/// `t` in the outer frame, along the axis of this row.
int64_t moved(const int32_t (&row)[3], const int32_t (&t)[3]) {
  return detail::fixed_rounded_wide(fixed_product(row[0], t[0]) + fixed_product(row[1], t[1]) +
                                    fixed_product(row[2], t[2]));
}

/// composed() without its limits: a translation beyond 32 bits wraps. No checked robot has one.
Frame joined(const Frame& outer, const Frame& inner) {
  Frame frame;
  const auto& r = inner.rotation;
  const auto& t = inner.translation;
  for (int i = 0; i < 3; ++i) {
    const auto& row = outer.rotation[i];
    for (int j = 0; j < 3; ++j) {
      frame.rotation[i][j] =
          fixed_rounded(fixed_product(row[0], r[0][j]) + fixed_product(row[1], r[1][j]) +
                        fixed_product(row[2], r[2][j]));
    }
    frame.translation[i] =
        detail::difference(outer.translation[i], -static_cast<int32_t>(moved(row, t)));
  }
  return frame;
}

}  // namespace

Status set_coordinates(const Robot& robot, const JointCoordinate* values,
                       JointCoordinate* coordinates) noexcept {
  if (!detail::is_open(robot)) {
    return Status::not_open;
  }
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.type != JointType::fixed && values[joint.variable] == kNoCoordinate) {
      return Status::not_a_coordinate;
    }
    const JointCoordinate coordinate = detail::coordinate_of(joint, values);
    const bool is_free = joint.type == JointType::continuous;
    coordinates[i] = is_free ? detail::wrapped(coordinate) : coordinate;
    if (!detail::can_be_at(joint, coordinates[i])) {
      return Status::joint_out_of_limits;
    }
  }
  return Status::done;
}

void set_frames(const Robot& robot, const JointCoordinate* coordinates, Frame* frames) noexcept {
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.parent == kBase) {
      frames[i] = joint.fixed;
    } else {
      frames[i] = joined(frames[joint.parent], joint.fixed);
    }
    if (joint.type == JointType::prismatic) {
      slide(frames[i], coordinates[i]);
    } else if (joint.type != JointType::fixed) {
      turn(frames[i], coordinates[i]);
    }
  }
}

Frame composed(const Frame& outer, const Frame& inner) noexcept {
  Frame frame = joined(outer, inner);
  for (int i = 0; i < 3; ++i) {
    const int64_t exact = outer.translation[i] + moved(outer.rotation[i], inner.translation);
    frame.translation[i] = static_cast<int32_t>(exact > INT32_MAX   ? INT32_MAX
                                                : exact < INT32_MIN ? INT32_MIN
                                                                    : exact);
  }
  return frame;
}

Pose relative_pose(const Frame& a, const Frame& b) noexcept {
  int32_t rotation[3][3];
  int32_t cells[3];
  int16_t fraction[3];
  int32_t between[3];
  const bool is_far[3] = {__builtin_sub_overflow(b.translation[0], a.translation[0], &between[0]),
                          __builtin_sub_overflow(b.translation[1], a.translation[1], &between[1]),
                          __builtin_sub_overflow(b.translation[2], a.translation[2], &between[2])};
  for (int i = 0; i < 3; ++i) {
    const int32_t column[3] = {a.rotation[0][i], a.rotation[1][i], a.rotation[2][i]};
    for (int j = 0; j < 3; ++j) {
      rotation[i][j] = fixed_rounded(fixed_product(column[0], b.rotation[0][j]) +
                                     fixed_product(column[1], b.rotation[1][j]) +
                                     fixed_product(column[2], b.rotation[2][j]));
    }
    const int64_t t = moved(column, between);
    cells[i] = static_cast<int32_t>((t + kFrameCell / 2) >> kFrameBits);
    const uint32_t rest =
        static_cast<uint32_t>(t) - (static_cast<uint32_t>(cells[i]) << kFrameBits);
    fraction[i] = static_cast<int16_t>(static_cast<int32_t>(rest) * (1 << (16 - kFrameBits)));
  }
  if (is_far[0] || is_far[1] || is_far[2]) {
    cells[0] = INT32_MAX;  // beyond all translations of a pose
  }
  return Pose::rigid(rotation, cells, fraction);
}

}  // namespace flashbvh
