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

}  // namespace

Status set_coordinates(const Robot& robot, const JointCoordinate* values,
                       JointCoordinate* coordinates) noexcept {
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
      frames[i] = composed(frames[joint.parent], joint.fixed);
    }
    if (joint.type == JointType::prismatic) {
      slide(frames[i], coordinates[i]);
    } else if (joint.type != JointType::fixed) {
      turn(frames[i], coordinates[i]);
    }
  }
}

Frame composed(const Frame& outer, const Frame& inner) noexcept {
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
    frame.translation[i] = outer.translation[i] +
                           fixed_rounded(fixed_product(row[0], t[0]) + fixed_product(row[1], t[1]) +
                                         fixed_product(row[2], t[2]));
  }
  return frame;
}

Pose relative_pose(const Frame& a, const Frame& b) noexcept {
  int32_t rotation[3][3];
  int32_t cells[3];
  int16_t fraction[3];
  const int32_t between[3] = {b.translation[0] - a.translation[0],
                              b.translation[1] - a.translation[1],
                              b.translation[2] - a.translation[2]};
  for (int i = 0; i < 3; ++i) {
    const int32_t column[3] = {a.rotation[0][i], a.rotation[1][i], a.rotation[2][i]};
    for (int j = 0; j < 3; ++j) {
      rotation[i][j] = fixed_rounded(fixed_product(column[0], b.rotation[0][j]) +
                                     fixed_product(column[1], b.rotation[1][j]) +
                                     fixed_product(column[2], b.rotation[2][j]));
    }
    const int32_t t =
        fixed_rounded(fixed_product(column[0], between[0]) + fixed_product(column[1], between[1]) +
                      fixed_product(column[2], between[2]));
    cells[i] = (t + kFrameCell / 2) >> kFrameBits;
    fraction[i] = static_cast<int16_t>((t - cells[i] * kFrameCell) * (1 << (16 - kFrameBits)));
  }
  return Pose::rigid(rotation, cells, fraction);
}

}  // namespace flashbvh
