// A robot as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "robot/baked/robot_file.hpp"

namespace flashbvh::python {

namespace py = pybind11;

/// A pair of links and whether they can collide, as `flashbvh robot` decided.
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
  tool::Model model;  ///< names and joints, no meshes
  std::vector<MatrixRow> matrix;
  bool has_matrix = false;  ///< of a robot that was baked, not loaded
};

/// The names of the links of pair `number` of the robot's.
py::tuple links_of_pair(const Robot& robot, std::uint16_t number);

}  // namespace flashbvh::python
