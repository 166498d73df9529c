#include "python/robot.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"
#include "image/output_name.hpp"
#include "python/bindings.hpp"

namespace flashbvh::python {
namespace {

std::unique_ptr<Robot> bake_robot(const tool::RobotArguments& arguments) {
  tool::Warnings warnings;
  std::unique_ptr<Robot> robot;
  {
    const py::gil_scoped_release release;
    const tool::BakedRobot baked =
        tool::baked_robot(tool::described_robot(arguments, warnings), arguments, warnings);
    // The image's name, as `flashbvh robot --format image` writes it.
    const std::string name = tool::distinct_names({baked.model.name}).front().stem;
    robot = opened<Robot>(arguments.urdf, tool::image_of(baked, name));
    robot->matrix = baked.pairs;
  }
  warn(warnings);
  return robot;
}

/// The options of `flashbvh robot`, as texts.
using Texts = std::vector<std::string>;
using Text = std::optional<std::string>;

std::unique_ptr<Robot> robot_of_urdf(const py::object& urdf, const std::string& stop,
                                     const Text& warn_length, const py::object& srdf,
                                     const Texts& believed, const Texts& packages, bool visual_too,
                                     const Text& cell, std::optional<std::uint32_t> leaf_size,
                                     const Text& simplify, const Text& fit, const Texts& pairs,
                                     const Texts& zones, const Text& time) {
  tool::RobotArguments arguments;
  arguments.urdf = path_of(urdf);
  arguments.stop = stop;
  arguments.warn = warn_length;
  arguments.srdf = srdf.is_none() ? "" : path_of(srdf);
  arguments.believed = believed;
  arguments.packages = packages;
  arguments.visual_too = visual_too;
  arguments.cell = cell;
  arguments.has_leaf_size = leaf_size.has_value();
  arguments.leaf_size = leaf_size.value_or(arguments.leaf_size);
  if (arguments.leaf_size < 1 || arguments.leaf_size > 16) {
    throw py::value_error("leaf_size: is out of range; give 1 to 16");
  }
  arguments.simplify = simplify;
  arguments.fit = fit;
  arguments.pairs = pairs;
  arguments.zones = zones;
  arguments.time = time;
  return bake_robot(arguments);
}

/// Names of the joints that the caller's values move, in the values' order.
py::list joint_names(const Robot& robot) {
  py::list names;
  for (const std::size_t joint : robot.names.variables) {
    names.append(text(robot.names.joints[joint].name));
  }
  return names;
}

py::array limits_of(const Robot& robot) {
  std::vector<std::array<double, 2>> limits;
  for (const std::size_t number : robot.names.variables) {
    const tool::ModelJoint& joint = robot.names.joints[number];
    const bool is_endless = joint.type == JointType::continuous;
    limits.push_back({is_endless ? -HUGE_VAL : joint.lower, is_endless ? HUGE_VAL : joint.upper});
  }
  return array_of(limits);
}

py::list link_names(const Robot& robot) {
  py::list names;
  for (std::size_t i = 0; i < robot.names.link_count(); ++i) {
    names.append(text(robot.names.links[i].name));
  }
  return names;
}

/// Rows (a, b, verdict, reason, whether it is guarded, witness or none), or none.
py::object matrix_rows(const Robot& robot) {
  if (!robot.matrix) {
    return py::none();
  }
  py::list rows;
  for (const tool::PairVerdict& pair : *robot.matrix) {
    py::object witness = py::none();
    if (!pair.witness.empty()) {
      witness = array_of(pair.witness);
    }
    rows.append(names_of(robot, pair.a, pair.b) +
                py::make_tuple(tool::name_of(pair), text(pair.reason), pair.is_guarded, witness));
  }
  return rows;
}

/// Rows (a, b, stop, warn) of the guarded pairs, lengths in metres.
py::list guarded_pairs(const Robot& robot) {
  py::list pairs;
  const flashbvh::Robot& fixed = robot.robot();
  for (std::uint16_t i = 0; i < fixed.pair_count; ++i) {
    pairs.append(links_of_pair(robot, i) +
                 py::make_tuple(tool::unit_length(fixed.pairs[i].stop, robot.cell()),
                                tool::unit_length(fixed.pairs[i].warn, robot.cell())));
  }
  return pairs;
}

/// Rows (a, b, reason).
py::list unguarded_pairs(const Robot& robot) {
  py::list pairs;
  for (const tool::UnguardedPair& pair : robot.unguarded()) {
    pairs.append(names_of(robot, pair.a, pair.b) +
                 py::make_tuple(text(tool::reason_of(robot.names, pair))));
  }
  return pairs;
}

}  // namespace

py::tuple names_of(const Robot& robot, std::size_t a, std::size_t b) {
  return py::make_tuple(text(robot.names.links[a].name), text(robot.names.links[b].name));
}

py::tuple links_of_pair(const Robot& robot, std::uint16_t number) {
  const RobotPair& pair = robot.robot().pairs[number];
  return names_of(robot, pair.a, pair.b);
}

void add_robots(py::module_& module) {
  add_image<Robot>(module, "Robot")
      .def_static("load", py::overload_cast<const py::object&>(opened<Robot>))
      .def_property_readonly("name", [](const Robot& robot) { return text(robot.name()); })
      .def_property_readonly("joint_names", joint_names)
      .def_property_readonly("limits", limits_of)
      .def_property_readonly("link_names", link_names)
      .def_property_readonly("matrix", matrix_rows)
      .def_property_readonly("pairs", guarded_pairs)
      .def_property_readonly("unguarded", unguarded_pairs);
  module.def("robot_of_urdf", robot_of_urdf);
}

}  // namespace flashbvh::python
