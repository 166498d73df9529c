#include "python/robot.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"
#include "image/output_name.hpp"
#include "python/bindings.hpp"
#include "text/files.hpp"

namespace flashbvh::python {
namespace {

py::ssize_t signed_size(std::size_t size) {
  return static_cast<py::ssize_t>(size);
}

Robot robot_of(std::unique_ptr<tool::RobotFile> file) {
  Robot robot;
  robot.model = file->model();
  robot.file = std::move(file);
  return robot;
}

Robot load_robot(const py::object& source) {
  if (py::isinstance<py::bytes>(source)) {
    return robot_of(std::make_unique<tool::RobotFile>("image", std::string(py::bytes(source))));
  }
  return robot_of(std::make_unique<tool::RobotFile>(path_of(source)));
}

/// The image, as `flashbvh robot --format image` writes it.
std::string robot_image_of(const tool::BakedRobot& baked) {
  const std::string name = tool::distinct_names({baked.model.name}).front().stem;
  const std::vector<std::uint32_t> words = tool::image_of(baked, name);
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]};
}

std::vector<MatrixRow> matrix_of(const tool::BakedRobot& baked) {
  std::vector<MatrixRow> rows;
  for (const tool::PairVerdict& pair : baked.pairs) {
    rows.push_back({baked.model.links[pair.a].name, baked.model.links[pair.b].name,
                    tool::name_of(pair.verdict), pair.reason, pair.is_guarded, pair.witness});
  }
  return rows;
}

Robot bake_robot(const tool::RobotArguments& arguments) {
  tool::Warnings warnings;
  Robot robot;
  {
    const py::gil_scoped_release release;
    const tool::BakedRobot baked =
        tool::baked_robot(tool::described_robot(arguments, warnings), arguments, warnings);
    robot = robot_of(std::make_unique<tool::RobotFile>(arguments.urdf, robot_image_of(baked)));
    robot.matrix = matrix_of(baked);
    robot.has_matrix = true;
  }
  warn(warnings);
  return robot;
}

/// The options of `flashbvh robot`, as texts.
using Texts = std::vector<std::string>;
using Text = std::optional<std::string>;

Robot robot_of_urdf(const py::object& urdf, const std::string& stop, const Text& warn_length,
                    const py::object& srdf, const Texts& believed, const Texts& packages,
                    const py::object& joint_limits, bool visual_too, const Text& cell,
                    std::optional<std::uint32_t> leaf_size, const Text& simplify, const Text& fit,
                    const Texts& pairs, const Texts& zones, const Text& time) {
  tool::RobotArguments arguments;
  arguments.urdf = path_of(urdf);
  arguments.stop = stop;
  arguments.warn = warn_length;
  arguments.srdf = srdf.is_none() ? "" : path_of(srdf);
  arguments.believed = believed;
  arguments.packages = packages;
  arguments.joint_limits = joint_limits.is_none() ? "" : path_of(joint_limits);
  arguments.visual_too = visual_too;
  arguments.cell = cell;
  if (leaf_size) {
    if (*leaf_size < 1 || *leaf_size > 16) {
      throw py::value_error("leaf_size: is out of range; give 1 to 16");
    }
    arguments.leaf_size = *leaf_size;
    arguments.has_leaf_size = true;
  }
  arguments.simplify = simplify;
  arguments.fit = fit;
  arguments.pairs = pairs;
  arguments.zones = zones;
  arguments.time = time;
  return bake_robot(arguments);
}

py::bytes image_bytes(const Robot& robot) {
  return {robot.file->bytes(), robot.file->header().byte_count};
}

/// Names of the joints that the caller's values move, in the values' order.
py::list joint_names(const Robot& robot) {
  py::list names;
  for (const std::size_t joint : robot.model.variables) {
    names.append(text(robot.model.joints[joint].name));
  }
  return names;
}

py::array_t<double> limits_of(const Robot& robot) {
  const std::vector<std::size_t>& variables = robot.model.variables;
  py::array_t<double> limits({signed_size(variables.size()), py::ssize_t{2}});
  double* to = limits.mutable_data();
  for (const std::size_t number : variables) {
    const tool::ModelJoint& joint = robot.model.joints[number];
    const bool is_endless = joint.type == JointType::continuous;
    *to++ = is_endless ? -HUGE_VAL : joint.lower;
    *to++ = is_endless ? HUGE_VAL : joint.upper;
  }
  return limits;
}

py::list link_names(const Robot& robot) {
  py::list names;
  for (std::size_t i = 0; i < robot.model.link_count(); ++i) {
    names.append(text(robot.model.links[i].name));
  }
  return names;
}

/// Rows (a, b, verdict, reason, whether it is guarded, witness or none), or none.
py::object matrix_rows(const Robot& robot) {
  if (!robot.has_matrix) {
    return py::none();
  }
  py::list rows;
  for (const MatrixRow& row : robot.matrix) {
    py::object witness = py::none();
    if (!row.witness.empty()) {
      witness = py::array_t<double>(signed_size(row.witness.size()), row.witness.data());
    }
    rows.append(py::make_tuple(text(row.a), text(row.b), row.verdict, text(row.reason),
                               row.is_guarded, witness));
  }
  return rows;
}

/// Rows (a, b, stop, warn) of the guarded pairs, lengths in metres.
py::list guarded_pairs(const Robot& robot) {
  py::list pairs;
  const flashbvh::Robot& fixed = robot.file->robot();
  const double cell = robot.file->cell();
  for (std::uint16_t i = 0; i < fixed.pair_count; ++i) {
    const py::tuple links = links_of_pair(robot, i);
    pairs.append(py::make_tuple(links[0], links[1], tool::unit_length(fixed.pairs[i].stop, cell),
                                tool::unit_length(fixed.pairs[i].warn, cell)));
  }
  return pairs;
}

/// Rows (a, b, reason).
py::list unguarded_pairs(const Robot& robot) {
  py::list pairs;
  for (const tool::UnguardedPair& pair : robot.file->unguarded()) {
    pairs.append(py::make_tuple(text(robot.model.links[pair.a].name),
                                text(robot.model.links[pair.b].name),
                                text(tool::reason_of(robot.model, pair))));
  }
  return pairs;
}

}  // namespace

py::tuple links_of_pair(const Robot& robot, std::uint16_t number) {
  const RobotPair& pair = robot.file->robot().pairs[number];
  return py::make_tuple(text(robot.model.links[pair.a].name), text(robot.model.links[pair.b].name));
}

void add_robots(py::module_& module) {
  py::class_<Robot>(module, "Robot")
      .def_static("load", load_robot)
      .def(
          "save",
          [](const Robot& robot, const py::object& path) {
            tool::write_file(path_of(path), {robot.file->bytes(), robot.file->header().byte_count});
          })
      .def_property_readonly("image", image_bytes)
      .def_property_readonly("name", [](const Robot& robot) { return text(robot.file->name()); })
      .def_property_readonly("cell", [](const Robot& robot) { return robot.file->cell(); })
      .def_property_readonly("joint_names", joint_names)
      .def_property_readonly("limits", limits_of)
      .def_property_readonly("link_names", link_names)
      .def_property_readonly("matrix", matrix_rows)
      .def_property_readonly("pairs", guarded_pairs)
      .def_property_readonly("unguarded", unguarded_pairs);
  module.def("robot_of_urdf", robot_of_urdf);
}

}  // namespace flashbvh::python
