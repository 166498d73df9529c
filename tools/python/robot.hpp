// A robot of the Python package.
#pragma once

#include <optional>
#include <vector>

#include "python/images.hpp"
#include "robot/baked/robot_file.hpp"
#include "robot/matrix/matrix.hpp"

namespace flashbvh::python {

struct Robot : tool::RobotFile {
  using RobotFile::RobotFile;

  tool::Model names = model();  ///< names and joints, without meshes
  /// All pairs of links, as `flashbvh robot` decided; none if the robot was loaded.
  std::optional<std::vector<tool::PairVerdict>> matrix;
};

/// The names of two links.
py::tuple names_of(const Robot& robot, std::size_t a, std::size_t b);
/// The link names of guarded pair `number`.
py::tuple links_of_pair(const Robot& robot, std::uint16_t number);

}  // namespace flashbvh::python
