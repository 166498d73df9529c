// flashbvh info: prints the contents of an image, or the cost of baking a mesh with the finest
// cell.
#include <algorithm>
#include <array>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "bake/bending.hpp"
#include "bake/image_bytes.hpp"
#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/mesh/mesh_warnings.hpp"
#include "cli/robot/robot_output.hpp"
#include "image/baking.hpp"
#include "image/image_file.hpp"
#include "mesh/import.hpp"
#include "mesh/units.hpp"
#include "report/subject.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::array<double, 3> in_unit(const LatticePoint& point, double cell) {
  return {static_cast<double>(point[0]) * cell, static_cast<double>(point[1]) * cell,
          static_cast<double>(point[2]) * cell};
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

void print_line(std::string label, const std::string& text) {
  std::replace(label.begin(), label.end(), '_', ' ');
  std::cout << std::left << std::setw(20) << label << text << "\n";
}

// Facts are names and values, in the order of both outputs.

Json facts_of(const ImageFile& image) {
  const ImageHeader& header = image.header();
  const NodeBox bounds = root_box(image.tree());
  const double cell = image.cell();
  const bake::BendingCost bending =
      std::visit([](const auto& tree) { return bake::bending_cost(tree); }, image.tree());
  const auto lower = in_unit(bounds.lower, cell);
  const auto upper = in_unit(bounds.upper, cell);
  const Size size = {upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]};
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
      {"box_cells", {{"lower", bounds.lower}, {"upper", bounds.upper}}},
  };
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

void print_image(const Json& facts, Unit image_unit) {
  for (const auto& [name, value] : facts.items()) {
    const std::string unit = unit_of(name, image_unit);
    print_line(name, concat(name == "bytes_per_triangle" ? fixed(value.get<double>(), 2)
                            : name == "size"             ? size_text(value.get<Size>(), "")
                                                         : text_of(value),
                            unit.empty() ? "" : "  ", unit));
  }
}

constexpr std::array<std::uint32_t, 4> kLeafSizes = {1, 2, 4, 8};

/// Bakes with 16-bit indices if they suffice.
AnyBakedTree tree_of(const InputMesh& mesh, const RoundedMesh& rounded, BakeOptions options) {
  try {
    return build_tree(mesh, rounded, options);
  } catch (const UserError&) {
    options.index_width = IndexWidth::bits_32;
    return build_tree(mesh, rounded, options);
  }
}

/// The bytes of flash; the image contains the file's name.
Json flash_of(AnyBakedTree tree, const std::string& path, std::uint32_t leaf_size) {
  return std::visit(
      [&](auto& baked) {
        baked.name = std::filesystem::path(path).stem().string().substr(0, bake::kMaxNameSize);
        const std::uint64_t bytes = image_size(baked);
        return Json{{"leaf_size", leaf_size},
                    {"index_bits", 8 * sizeof baked.triangle_ids[0]},
                    {"bytes", bytes},
                    {"bytes_per_triangle",
                     static_cast<double>(bytes) / static_cast<double>(baked.triangles.size())}};
      },
      tree);
}

Json box_of(const bake::SourceMesh& mesh) {
  auto lower = mesh.vertices.front();
  auto upper = lower;
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], vertex[axis]);
      upper[axis] = std::max(upper[axis], vertex[axis]);
    }
  }
  return {{"lower", lower}, {"upper", upper}};
}

Json defects_as_json(const MeshDefects& defects) {
  return {{"degenerate", defects.degenerate.size()},
          {"collapsed", defects.collapsed.size()},
          {"duplicate", defects.duplicates.size()},
          {"boundary_edges", defects.edges.boundary},
          {"non_manifold_edges", defects.edges.non_manifold},
          {"twisted_edges", defects.edges.twisted}};
}

Json facts_of(const InputMesh& mesh, Warnings& warnings) {
  BakeOptions options;
  options.cell = finest_cell(mesh);
  Json facts = {{"name", mesh.path},
                {"triangles", mesh.mesh.triangles.size()},
                {"vertices", mesh.mesh.vertices.size()},
                {"bodies", mesh.bodies},
                {"box", box_of(mesh.mesh)},
                {"size", size_of(mesh.mesh)},
                {"finest_cell", *options.cell}};
  const RoundedMesh rounded = round_mesh(mesh, options);
  warn_of_mesh(mesh, rounded.defects, options, warnings);
  facts["deviation"] = rounded.lattice.deviation;
  facts["defects"] = defects_as_json(rounded.defects);
  for (const std::uint32_t leaf_size : kLeafSizes) {
    options.leaf_size = leaf_size;
    facts["flash"].push_back(flash_of(tree_of(mesh, rounded, options), mesh.path, leaf_size));
  }
  return facts;
}

void print_mesh(const Json& facts) {
  print_line("name", one_line(facts["name"].get<std::string>()));
  print_line("triangles", facts["triangles"].dump());
  print_line("vertices", facts["vertices"].dump());
  print_line("bodies", concat(facts["bodies"].size()));
  print_line("box", text_of(facts["box"]));
  print_line("size", size_text(facts["size"].get<Size>(), ""));
  print_line("finest cell", text_of(facts["finest_cell"]));
  print_line("deviation", text_of(facts["deviation"]));
  for (const Json& flash : facts["flash"]) {
    print_line("flash, leaf size " + flash["leaf_size"].dump(),
               concat(flash["bytes"].dump(), " bytes, ",
                      fixed(flash["bytes_per_triangle"].get<double>(), 1), " a triangle, with ",
                      flash["index_bits"].dump(), "-bit indices"));
  }
  print_line(
      "",
      "larger leaves make the worst pose more expensive: see `collide --bound` on the baked image");
}

struct InfoArguments {
  std::string image;
  bool json = false;
};

void info(const InfoArguments& arguments) {
  const auto& [path, json] = arguments;
  if (is_robot_file_name(path)) {
    return (json ? print_robot_file_json : print_robot_file)(RobotFile(path));
  }
  if (is_mesh_name(path)) {
    Warnings warnings;
    const Json facts = facts_of(read_mesh(path, Units(), warnings), warnings);
    warnings.print();
    return (json ? print_object : print_mesh)(facts);
  }
  const ImageFile image(path);
  const Json facts = facts_of(image);
  if (json) {
    return print_object(facts);
  }
  print_image(facts, image.unit());
}

}  // namespace

void add_info(CLI::App& app) {
  auto [command, a] = add_command<InfoArguments>(
      app, "info",
      "Print what is in an image of a mesh or a robot,\nor what baking a mesh would take.", info);
  add_image(command, a.image, "FILE", "Image (.fbvh, .robot) or mesh");
  add_json(command, a.json, "As one JSON object");
  add_example(command, "info baked/plate.fbvh", "prints triangles, nodes, box and bytes");
}

}  // namespace flashbvh::tool
