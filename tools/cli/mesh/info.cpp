// flashbvh info: proves that an image is well-formed, and prints its contents.
#include <array>
#include <iostream>

#include "bake/bending.hpp"
#include "cli/commands.hpp"
#include "cli/mesh/image_facts.hpp"
#include "cli/robot/robot_output.hpp"
#include "cli/table.hpp"
#include "image/image_file.hpp"
#include "image/mesh_warnings.hpp"
#include "mesh/units.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A point in cells of the mesh's frame.
using LatticePoint = std::array<std::int64_t, 3>;

/// The root's box: its lower and its upper corner.
std::array<LatticePoint, 2> root_box(const AnyTree& any) {
  return std::visit(
      [](const auto& tree) -> std::array<LatticePoint, 2> {
        const auto box = unpack(tree.nodes[0].box);
        const auto framed = [&](const Vertex& v) -> LatticePoint {
          const auto& o = tree.origin;
          return {std::int64_t{v.x} + o[0], std::int64_t{v.y} + o[1], std::int64_t{v.z} + o[2]};
        };
        return {framed(box.lower), framed(box.upper)};
      },
      any);
}

std::string text_of(const Json& value) {
  if (value.is_string()) {
    const std::string text = value.get<std::string>();
    return text.empty() ? "unknown" : text;
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? "yes" : "no";
  }
  if (value.is_number_float()) {
    return shortest(value.get<double>());
  }
  if (value.is_array()) {
    std::string text;
    for (const Json& element : value) {
      text += (text.empty() ? "" : " ") + text_of(element);
    }
    return text;
  }
  if (value.is_object()) {
    return text_of(value["lower"]) + "  to  " + text_of(value["upper"]);
  }
  return value.dump();
}

/// The unit of a value; empty if the name implies it.
std::string unit_of(const std::string& name, Unit unit) {
  if (name == "origin" || name == "box_cells") {
    return "cells";
  }
  const bool length = name == "cell" || name == "deviation" || name == "longest_edge" ||
                      name == "box" || name == "size";
  if (name == "ram_to_bend" || name == "refit_instructions") {
    return name == "ram_to_bend" ? "bytes" : "about, on a Cortex-M4F";
  }
  return !length ? "" : unit == Unit::none ? "of the mesh's unit" : unit_name(unit);
}

struct InfoArguments {
  std::string image;
  bool json = false;
};

void info(const InfoArguments& arguments) {
  const auto& [path, json] = arguments;
  if (is_robot_file_name(path)) {
    const RobotFile file(path);
    check_whole(file.robot(), path);
    return print_robot_file(file, json);
  }
  const ImageFile image(path);
  check_whole(image);
  const Json facts = image_facts(image);
  if (json) {
    print_object(facts);
    return;
  }
  std::cout << image.name() << ": well-formed, a mesh\n";
  for (const auto& [name, value] : facts.items()) {
    const std::string unit = unit_of(name, image.unit());
    std::string label = name;
    for (char& c : label) {
      c = c == '_' ? ' ' : c;
    }
    label.resize(20, ' ');
    std::cout << label
              << (name == "bytes_per_triangle" ? fixed(value.get<double>(), 2)
                  : name == "size"             ? size_text(value.get<Size>(), "")
                                               : text_of(value))
              << (unit.empty() ? "" : "  " + unit) << "\n";
  }
}

}  // namespace

Json image_facts(const ImageFile& image) {
  const ImageHeader& header = image.header();
  const auto [low, high] = root_box(image.tree());
  const double cell = image.cell();
  const bake::BendingCost bending =
      std::visit([](const auto& tree) { return bake::bending_cost(tree); }, image.tree());
  Size lower{};
  Size upper{};
  Size size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lower[axis] = static_cast<double>(low[axis]) * cell;
    upper[axis] = static_cast<double>(high[axis]) * cell;
    size[axis] = upper[axis] - lower[axis];
  }
  return {
      {"name", image.source()},
      {"format_version", header.version},
      {"layout", layout_name(image.layout())},
      {"index_bits", header.index_bits},
      {"nodes", header.node_count},
      {"leaves", header.leaf_count},
      {"depth", header.depth},
      {"stack_need", header.stack_need},
      {"triangles", header.triangle_count},
      {"vertices", header.vertex_count},
      {"leaf_size", header.leaf_size},
      {"arity", header.arity},
      {"levels", (header.flags & kImageHasLevels) != 0},
      {"closed", (header.flags & kImageIsClosed) != 0},
      {"shells", header.shell_count},
      {"bytes", header.byte_count},
      {"bytes_per_triangle", static_cast<double>(header.byte_count) / header.triangle_count},
      {"ram_to_bend", bending.ram_bytes},
      {"refit_instructions", bending.refit_instructions},
      {"unit", unit_name(image.unit())},
      {"cell", cell},
      {"deviation", image.deviation()},
      {"longest_edge", header.longest_edge * cell},
      {"origin", header.origin},
      {"box", {{"lower", lower}, {"upper", upper}}},
      {"size", size},
      {"box_cells", {{"lower", low}, {"upper", high}}},
  };
}

void add_info(CLI::App& app) {
  auto [command, a] = add_command<InfoArguments>(
      app, "info",
      "Prove that an image of a mesh or a robot is well-formed, and print what is in it.", info);
  add_option(command, "IMAGE", a.image, "FILE", "Image (.fbvh, .robot)")->required();
  command.add_flag("--json", a.json, "As one JSON object");
  add_example(command, "info baked/plate.fbvh", "prints triangles, nodes, box and bytes");
}

}  // namespace flashbvh::tool
