// flashbvh bake: everything is read and baked before the first file is written.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <set>

#include "bake/image_bytes.hpp"
#include "cli/bake_report.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "image/baking.hpp"
#include "image/cpp_writer.hpp"
#include "image/output_name.hpp"
#include "mesh/import.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"
#include "text/user_error.hpp"

namespace flashbvh::tool {
namespace {

struct BakeArguments {
  std::vector<std::string> meshes;
  std::string folder;
  std::string format = "both";
  std::optional<std::string> cell;
  std::string layout = "post";
  std::string builder = "sah";
  std::string name;
  std::uint32_t leaf_size = 1;
  std::optional<std::uint32_t> arity;
  unsigned index_bits = 16;
  std::optional<std::int64_t> max_bytes;
  std::optional<std::string> max_deviation;
  std::vector<std::string> units;
  std::vector<std::string> drop;
  bool progress = false;
};

/// Output files and namespaces must not collide.
std::vector<OutputName> output_names(const BakeArguments& arguments) {
  if (!arguments.name.empty() && arguments.meshes.size() > 1) {
    throw UserError("--name", "names one mesh, but " + std::to_string(arguments.meshes.size()) +
                                  " are given; bake them one by one with the same --cell");
  }
  std::vector<OutputName> names;
  std::set<std::string> taken;
  for (const std::string& mesh : arguments.meshes) {
    names.push_back(output_name(mesh, arguments.name));
    if (!taken.insert(names.back().identifier).second) {
      throw UserError(mesh, "would be written as '" + names.back().identifier +
                                "' like a mesh before it; rename one of the files");
    }
  }
  return names;
}

/// A length from the command line that firmware can hold in a float. `least`: the smallest.
double length_of(const std::string& option, const std::string& text, double least) {
  const std::optional<double> length = parse_number(text);
  if (!length || *length < least ||
      *length > static_cast<double>(std::numeric_limits<float>::max())) {
    throw UserError(option + " " + text, std::string("is no length; give a ") +
                                             (least > 0 ? "positive number" : "number from 0") +
                                             " in the mesh's unit");
  }
  return *length;
}

double common_cell(const BakeArguments& arguments, const std::vector<InputMesh>& meshes) {
  if (arguments.cell) {
    return length_of("--cell", *arguments.cell,
                     static_cast<double>(std::numeric_limits<float>::min()));
  }
  double cell = 0;
  for (const InputMesh& mesh : meshes) {
    cell = std::max(cell, finest_float_cell(mesh.mesh));
  }
  return cell;
}

void check_budget(const BakeArguments& arguments, const std::string& mesh, std::size_t bytes) {
  if (arguments.max_bytes && static_cast<std::int64_t>(bytes) > *arguments.max_bytes) {
    throw UserError(mesh, "takes " + std::to_string(bytes) + " bytes, --max-bytes allows " +
                              std::to_string(*arguments.max_bytes) +
                              "; use a larger --leaf-size or fewer triangles");
  }
}

template <class Baked>
std::string image_file(const Baked& baked, const std::string& path) {
  if (image_size(baked) > 0xFFFFFFFFu) {
    throw UserError(path, "the image would be over 4 GiB; use fewer triangles");
  }
  const std::vector<std::uint32_t> words = image_of(baked);
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]};
}

BakeOptions options_of(const BakeArguments& arguments) {
  BakeOptions options;
  options.layout = arguments.layout == "pre" ? Layout::pre_indexed : Layout::post_indexed;
  options.index_bits = arguments.index_bits;
  options.leaf_size = arguments.leaf_size;
  options.builder = arguments.builder == "median" ? Builder::median : Builder::sah;
  // Two children a node are part of what makes the median tree the paper's.
  options.arity =
      arguments.arity.value_or(options.builder == Builder::median ? 2 : bake::kDefaultArity);
  if (arguments.max_deviation) {
    options.max_deviation = length_of("--max-deviation", *arguments.max_deviation, 0);
  }
  for (const std::string& kind : arguments.drop) {
    options.drop_degenerate = options.drop_degenerate || kind == "degenerate";
    options.drop_duplicate = options.drop_duplicate || kind == "duplicate";
  }
  return options;
}

BakeResult bake_one(const BakeArguments& arguments, const InputMesh& mesh, double cell,
                    const OutputName& name, FileSet& files) {
  const std::string unit = Units(arguments.units, arguments.meshes).common();
  BakeResult result = {name, bake_mesh(mesh, cell, options_of(arguments)), 0, 0};
  const std::filesystem::path stem = std::filesystem::path(arguments.folder) / name.stem;
  std::visit(
      [&](const auto& baked) {
        result.image_bytes = image_size(baked);
        result.flash_bytes = flash_bytes(baked);
        check_budget(arguments, mesh.path, result.image_bytes);
        if (arguments.format != "cpp") {
          files.add(stem.string() + ".fbvh", image_file(baked, mesh.path));
        }
        if (arguments.format != "image") {
          CppFiles cpp = cpp_of(baked, name, unit);
          files.add(stem.string() + ".fbvh.hpp", std::move(cpp.header));
          files.add(stem.string() + ".fbvh.cpp", std::move(cpp.source));
        }
      },
      result.baked.tree);
  return result;
}

std::vector<InputMesh> read_meshes(const BakeArguments& arguments,
                                   const std::vector<double>& weights, Progress& progress,
                                   Warnings& warnings) {
  const Units units(arguments.units, arguments.meshes);
  std::vector<InputMesh> meshes;
  for (const std::string& path : arguments.meshes) {
    progress.begin("reading " + path, weights[meshes.size()]);
    meshes.push_back({path, import_mesh(path, warnings), {}});
    meshes.back().degenerate = degenerate_triangles(meshes.back().mesh);
    units.convert(meshes.back().mesh, path);
  }
  return meshes;
}

/// Reading a mesh takes about as long as baking it; both grow with the file.
std::vector<double> weights_of(const std::vector<std::string>& paths) {
  std::vector<double> weights;
  for (const std::string& path : paths) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    weights.push_back(unknown ? 1 : static_cast<double>(size));
  }
  return weights;
}

/// Everything but the reports.
std::vector<BakeResult> bake_and_write(const BakeArguments& arguments, double& cell,
                                       Warnings& warnings) {
  const std::vector<OutputName> names = output_names(arguments);
  const std::vector<double> weights = weights_of(arguments.meshes);
  const double total = 2 * std::accumulate(weights.begin(), weights.end(), 0.0);
  Progress progress(total, arguments.progress);
  const std::vector<InputMesh> meshes = read_meshes(arguments, weights, progress, warnings);
  cell = common_cell(arguments, meshes);
  FileSet files;
  std::vector<BakeResult> results;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    progress.begin("baking " + meshes[i].path, weights[i]);
    results.push_back(bake_one(arguments, meshes[i], cell, names[i], files));
    warn_of_defects(results.back().baked.defects, options_of(arguments), meshes[i].path, warnings);
  }
  progress.begin("writing " + arguments.folder, 0);
  files.write();
  return results;
}

void bake_all(const BakeArguments& arguments) {
  Warnings warnings;
  double cell = 0;
  const std::vector<BakeResult> results = bake_and_write(arguments, cell, warnings);
  warnings.print();
  print_table(results, Units(arguments.units, arguments.meshes).with_unit(cell));
}

/// What meshes are taken as, and what is refused.
void add_mesh_options(CLI::App& command, BakeArguments& a) {
  command.add_option("--max-bytes", a.max_bytes, "Refuse to write if an image is larger")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--max-deviation", a.max_deviation,
                  "Refuse to write if rounding moves a vertex further")
      ->type_name("LENGTH");
  add_unit_option(command, a.units);
  command
      .add_option("--drop", a.drop,
                  "Leave out triangles without area (`degenerate`) or with the three vertices of "
                  "an\nearlier one (`duplicate`), or both, with a comma between. The others keep "
                  "their numbers")
      ->check(CLI::IsMember({"degenerate", "duplicate"}))
      ->type_size(1)
      ->expected(1)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_flag("--progress", a.progress,
                   "Show a progress bar at once; default: on a terminal, after a second");
}

}  // namespace

void add_bake(CLI::App& app) {
  const auto arguments = std::make_shared<BakeArguments>();
  BakeArguments& a = *arguments;
  CLI::App* const command = app.add_subcommand(
      "bake",
      "Turn meshes (STL, OBJ, PLY, OFF) into trees: C++ arrays and binary images.\n"
      "Meshes that meet each other share a cell: bake them in one call.");
  command->add_option("MESH", a.meshes, "Mesh files")->required();
  command->add_option("-o,--output", a.folder, "Folder for the results; made if there is none")
      ->required()
      ->type_name("DIR");
  command->add_option("--format", a.format, "What to write")
      ->check(CLI::IsMember({"cpp", "image", "both"}))
      ->capture_default_str();
  command
      ->add_option("--cell", a.cell,
                   "Size of a lattice cell in the mesh's unit; default: the "
                   "finest that all the meshes fit")
      ->type_name("LENGTH");
  command
      ->add_option("--layout", a.layout,
                   "Order of the nodes: pre for `stackless`, post for "
                   "`ranked` and `stackless-post`")
      ->check(CLI::IsMember({"pre", "post"}))
      ->capture_default_str();
  command
      ->add_option("--builder", a.builder,
                   "How triangles are grouped: median is the paper's, sah gives faster queries")
      ->check(CLI::IsMember({"median", "sah"}))
      ->capture_default_str();
  command->add_option("--leaf-size", a.leaf_size, "Most triangles in a leaf")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  command
      ->add_option("--arity", a.arity,
                   "Most children of a node; default: 4, with --builder median 2")
      ->check(CLI::Range(2, 8));
  command->add_option("--index-bits", a.index_bits, "Width of indices; 16 reach 65535 nodes")
      ->check(CLI::IsMember({16, 32}))
      ->capture_default_str();
  command->add_option("--name", a.name,
                      "Name of the files and the namespace, for one mesh; "
                      "default: that of the mesh file");
  add_mesh_options(*command, a);
  command->callback([arguments] { bake_all(*arguments); });
}

}  // namespace flashbvh::tool
