#include "flashbvh/lattice_pose.hpp"

#include <cmath>

#include "flashbvh/numbers.hpp"
#include "flashbvh/user_error.hpp"

namespace flashbvh::tool {

Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      if (pose.rotation[row][column] != (row == column ? 1.0 : 0.0)) {
        throw UserError(place,
                        "the pose turns B, which this version does not support; begin it "
                        "with 1 0 0 0 1 0 0 0 1");
      }
    }
  }
  std::int32_t cells[3] = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double moved = std::round(pose.translation[axis] / cell);
    if (!(std::fabs(moved) <= kMaxTranslation)) {
      throw UserError(place, "the pose moves B by " + shortest(pose.translation[axis]) +
                                 ", the most is " + shortest(kMaxTranslation * cell) + " (" +
                                 std::to_string(kMaxTranslation) + " cells)");
    }
    cells[axis] = static_cast<std::int32_t>(moved);
  }
  return Pose::translated(cells[0], cells[1], cells[2]);
}

std::array<std::int64_t, 3> placed(const std::array<std::int64_t, 3>& point, const Pose& pose) {
  return {point[0] + pose.translation(0), point[1] + pose.translation(1),
          point[2] + pose.translation(2)};
}

}  // namespace flashbvh::tool
