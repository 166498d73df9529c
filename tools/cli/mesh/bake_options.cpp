#include "cli/mesh/bake_options.hpp"
#include "cli/commands.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "image/simplify_options.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The options as given on the command line.
struct Arguments {
  BakeOrder order;
  std::string format = "both";
  std::string layout = "post";
  std::string builder = "sah";
  std::optional<std::string> name;
  std::optional<std::uint32_t> leaf_size;
  std::optional<std::uint32_t> arity;
  std::string index_bits = "16";
  std::vector<std::string> units;
  std::vector<std::string> drop;
};

/// The names of all outputs. UserError if files or names collide.
std::vector<OutputName> output_names(const Arguments& arguments) {
  const std::string chosen = arguments.name.value_or("");
  if (arguments.name && chosen.empty()) {
    throw UserError("--name", "is empty; give a name of letters, digits and '_', or none");
  }
  if (arguments.name && arguments.order.meshes.size() > 1) {
    throw UserError("--name", "names one mesh, but ", arguments.order.meshes.size(),
                    " are given; bake them one by one with the same --cell");
  }
  std::vector<OutputName> names;
  TakenOutputs taken;
  for (const std::string& mesh : arguments.order.meshes) {
    names.push_back(output_name(mesh, chosen));
    taken.add(names.back(), mesh, "rename one of the files");
  }
  return names;
}

/// The least positive length that a float in firmware can hold.
constexpr auto kLeastLength = static_cast<double>(std::numeric_limits<float>::min());

/// Declares an option that is a length from `least` on which a float in firmware can hold.
void add_length(CLI::App& command, const std::string& name, std::optional<double>& to, double least,
                const std::string& what) {
  const auto read = [name, &to, least](const std::string& text) {
    to = parse_number(text);
    if (!to || *to < least || *to > static_cast<double>(std::numeric_limits<float>::max())) {
      throw UserError(name + " " + text, "is no length; give a ",
                      least > 0 ? "positive number" : "number from 0", " in the mesh's unit");
    }
  };
  command.add_option_function<std::string>(name, read, what)->type_name("LENGTH");
}

BakeOptions options_of(const Arguments& arguments) {
  BakeOptions options = arguments.order.options;
  const bool median = arguments.builder == "median";
  options.layout = arguments.layout == "pre" ? Layout::pre_indexed : Layout::post_indexed;
  options.index_width = arguments.index_bits == "16" ? IndexWidth::bits_16 : IndexWidth::bits_32;
  options.builder = median ? Builder::median : Builder::sah;
  // The paper's median tree has one triangle per leaf and two children per node.
  options.leaf_size =
      arguments.leaf_size.value_or(median                       ? 1
                                   : arguments.order.deformable ? bake::kBendingLeafSize
                                                                : bake::kDefaultLeafSize);
  options.arity = arguments.arity.value_or(median ? 2 : bake::kDefaultArity);
  const auto drops = [&](const char* kind) {
    return std::find(arguments.drop.begin(), arguments.drop.end(), kind) != arguments.drop.end();
  };
  options.drop_degenerate = drops("degenerate");
  options.drop_duplicate = drops("duplicate");
  return options;
}

BakeOrder order_of(const Arguments& arguments) {
  BakeOrder order = arguments.order;
  if (order.folder.empty() && !order.dry_run) {
    throw CLI::RequiredError("--output or --dry-run");
  }
  order.names = output_names(arguments);
  order.units = Units(arguments.units, order.meshes);
  order.options = options_of(arguments);
  order.options.unit = order.units.common();
  check_simplify_or_fit(order.simplify.has_value(), order.fit.has_value());
  if (order.deformable && (order.simplify || order.fit)) {
    throw UserError("--deformable",
                    "keeps the file's vertices, which the program moves; "
                    "simplify the mesh before it is given shape keys or bones");
  }
  order.leaf_sizes = {order.options.leaf_size};
  if (!arguments.leaf_size && order.options.leaf_size < kLargeLeaf) {
    order.leaf_sizes.push_back(kLargeLeaf);
  }
  order.writes_c = arguments.format != "image";
  order.writes_images = arguments.format != "c";
  return order;
}

/// Declares options that define how meshes are read, simplified and refused.
void add_mesh_options(CLI::App& command, Arguments& a) {
  add_length(command, "--max-deviation", a.order.options.max_deviation, 0,
             "Refuse to write if rounding moves a vertex further, or a simplified mesh lies "
             "further off");
  add_length(
      command, "--simplify", a.order.simplify, kLeastLength,
      "Bake fewer triangles: as few as keep each point within LENGTH of the file's mesh, and "
      "the file's\nwithin LENGTH of it, proven; triangles are numbered again");
  const auto read_fit = [&a](const std::string& text) { a.order.fit = bytes_to_fit(text); };
  command
      .add_option_function<std::string>(
          "--fit", read_fit,
          "Simplify as little as it takes for all the images together, and choose --leaf-size")
      ->type_name("BYTES");
  add_unit_option(command, a.units);
  CLI::Option* const drop = command.add_option(
      "--drop", a.drop,
      "Leave out triangles without area (`degenerate`) or with the three vertices of an\nearlier "
      "one (`duplicate`), or both, with a comma between. The others keep their numbers");
  repeated(drop)->check(CLI::IsMember({"degenerate", "duplicate"}))->delimiter(',');
}

}  // namespace

void add_unit_option(CLI::App& command, std::vector<std::string>& given) {
  repeated(add_option(
      command, "--unit", given, "UNIT|FILE=UNIT",
      "Unit of the meshes and of all other lengths, given and printed: " +
          std::string(Units::kNames) +
          ".\nFiles that carry a unit (DAE, glTF, 3MF) are converted. FILE=UNIT: this file alone "
          "is in another unit and is converted. May be repeated. Default: numbers as "
          "they are"));
}

void add_bake_options(CLI::App& command, const std::function<void(const BakeOrder&)>& run) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
  add_option(command, "MESH", a.order.meshes, "FILE", "Mesh files")->required();
  add_option(command, "-o,--output", a.order.folder, "DIR",
             "Folder for the results; made if there is none");
  command.add_flag("--dry-run", a.order.dry_run,
                   "Print the table and what is wrong, and write no image");
  command.add_flag("--json", a.order.json, "Print the table as one JSON object");
  add_choice(command, "--format", a.format, {"c", "image", "both"},
             "What to write: the image as an array of C and C++ (c), as a binary file (image),\nor "
             "both");
  add_length(
      command, "--cell", a.order.options.cell, kLeastLength,
      "Size of a lattice cell in the mesh's unit; default: the finest that all the meshes fit");
  command.add_flag(
      "--deformable", a.order.deformable,
      "For meshes that bend: the default cell is twice the finest, so that each may\n"
      "reach half of its width beyond its box, and corners are turned for refits; says what\n"
      "they take");
  add_choice(command, "--layout", a.layout, {"pre", "post"},
             "Order of the nodes: pre for `stackless`, post for `ranked` and `stackless-post`");
  command.add_flag("--levels", a.order.levels,
                   "Put levels into post-indexed images, for `stackless-post` and "
                   "`alternating-stack`");
  add_choice(command, "--builder", a.builder, {"median", "sah"},
             "How triangles are grouped: median is the paper's, sah gives faster queries");
  command
      .add_option(
          "--leaf-size", a.leaf_size,
          "Most triangles in a leaf; default: up to 4, as 27 bytes of flash a triangle allow; "
          "with --deformable 2, with --builder median 1")
      ->check(CLI::Range(1, 16));
  command
      .add_option("--arity", a.arity,
                  "Most children of a node; default: 4, with --builder median 2")
      ->check(CLI::Range(2, 8));
  add_choice(command, "--index-bits", a.index_bits, {"16", "32"},
             "Width of indices; 16 reach 65535 nodes");
  command.add_option(
      "--name", a.name,
      "Name of the files and of their contents, for one mesh; default: that of the mesh file");
  add_mesh_options(command, a);
  command.callback([arguments, run] { run(order_of(*arguments)); });
}

}  // namespace flashbvh::tool
