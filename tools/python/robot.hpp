// A robot of the Python package.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "robot/baked/robot_file.hpp"

namespace flashbvh::python {

namespace py = pybind11;

/// A pair of links and whether it can collide, as `flashbvh robot` decided.
struct MatrixRow {
  std::string a;
  std::string b;
  std::string verdict;
  std::string reason;
  bool is_guarded;
  std::vector<double> witness;
};

struct Robot {
  std::shared_ptr<const tool::RobotFile> file;
  tool::Model model;  ///< names and joints, without meshes
  std::vector<MatrixRow> matrix;
  bool has_matrix = false;  ///< true if baked, false if loaded
};

/// The link names of pair `number` of the robot.
py::tuple links_of_pair(const Robot& robot, std::uint16_t number);

}  // namespace flashbvh::python
