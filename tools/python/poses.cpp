#include "python/poses.hpp"

#include <cmath>

#include "evaluate/poses.hpp"
#include "flashbvh/float.hpp"
#include "text/messages.hpp"

namespace flashbvh::python {
namespace {

constexpr std::size_t kEntries = 16;

/// Throws UserError, with the tool's message, for a pose that pose_of() refuses.
[[noreturn]] void refuse_pose(const double* matrix, double cell, const std::string& place) {
  tool::RigidPose pose{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose.rotation[i][j] = matrix[4 * i + j];
    }
    pose.translation[i] = matrix[4 * i + 3];
  }
  (void)tool::lattice_pose(pose, cell, place);
  throw tool::UserError(place, "the matrix, as 32-bit floats, is no rigid motion");
}

}  // namespace

std::string place_of(const char* argument, std::size_t number) {
  return tool::concat(argument, "[", number, "]");
}

Poses::Poses(const py::object& given, const char* name)
    : name_(name), matrices_(numbers(given, {name, {4, 4}})) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < size(); ++i) {
    const double* const row = matrices_.data + kEntries * i + 12;
    if (std::fabs(row[0]) > kRounding || std::fabs(row[1]) > kRounding ||
        std::fabs(row[2]) > kRounding || std::fabs(row[3] - 1) > kRounding) {
      throw py::value_error(tool::concat(name, ": the last row of matrix ", i,
                                         " is not 0 0 0 1; give homogeneous matrices"));
    }
  }
}

Pose Poses::at(std::size_t number, double cell, float cells) const {
  const double* const from = matrices_.data + kEntries * number;
  float matrix[3][4];
  for (std::size_t entry = 0; entry < 12; ++entry) {
    matrix[entry / 4][entry % 4] = static_cast<float>(from[entry]);
  }
  const Pose pose = pose_of(matrix, cells);
  if (pose.status() != Status::done) {
    refuse_pose(from, cell, place_of(name_, number));
  }
  return pose;
}

}  // namespace flashbvh::python
