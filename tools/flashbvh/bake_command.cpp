// flashbvh bake: everything is read and baked before the first file is written.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <set>

#include "bake/image_bytes.hpp"
#include "flashbvh/baking.hpp"
#include "flashbvh/commands.hpp"
#include "flashbvh/cpp_writer.hpp"
#include "flashbvh/files.hpp"
#include "flashbvh/mesh_import.hpp"
#include "flashbvh/numbers.hpp"
#include "flashbvh/output_name.hpp"
#include "flashbvh/user_error.hpp"

namespace flashbvh::tool {
namespace {

struct Arguments {
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
};

/// What one mesh became.
struct Result {
  OutputName name;
  BakedMesh baked;
  std::size_t image_bytes;
  std::size_t flash_bytes;
};

/// Output files and namespaces must not collide.
std::vector<OutputName> output_names(const Arguments& arguments) {
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

double common_cell(const Arguments& arguments, const std::vector<bake::SourceMesh>& meshes) {
  if (!arguments.cell) {
    double cell = 0;
    for (const bake::SourceMesh& mesh : meshes) {
      cell = std::max(cell, finest_float_cell(mesh));
    }
    return cell;
  }
  const std::optional<double> cell = parse_number(*arguments.cell);
  using Float = std::numeric_limits<float>;
  if (!cell || *cell < static_cast<double>(Float::min()) ||
      *cell > static_cast<double>(Float::max())) {
    throw UserError("--cell " + *arguments.cell,
                    "is no length; give a positive number in the mesh's unit");
  }
  return *cell;
}

void check_budget(const Arguments& arguments, const std::string& mesh, std::size_t bytes) {
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

Result bake_one(const Arguments& arguments, std::size_t index, const bake::SourceMesh& mesh,
                double cell, const OutputName& name, FileSet& files) {
  const std::string& path = arguments.meshes[index];
  BakeOptions options;
  options.layout = arguments.layout == "pre" ? Layout::pre_indexed : Layout::post_indexed;
  options.index_bits = arguments.index_bits;
  options.leaf_size = arguments.leaf_size;
  options.builder = arguments.builder == "median" ? Builder::median : Builder::sah;
  // Two children a node are part of what makes the median tree the paper's.
  options.arity =
      arguments.arity.value_or(options.builder == Builder::median ? 2 : bake::kDefaultArity);
  Result result = {name, bake_mesh(mesh, cell, options, path), 0, 0};
  const std::filesystem::path stem = std::filesystem::path(arguments.folder) / name.stem;
  std::visit(
      [&](const auto& baked) {
        result.image_bytes = image_size(baked);
        result.flash_bytes = flash_bytes(baked);
        check_budget(arguments, path, result.image_bytes);
        if (arguments.format != "cpp") {
          files.add(stem.string() + ".fbvh", image_file(baked, path));
        }
        if (arguments.format != "image") {
          CppFiles cpp = cpp_of(baked, name);
          files.add(stem.string() + ".fbvh.hpp", std::move(cpp.header));
          files.add(stem.string() + ".fbvh.cpp", std::move(cpp.source));
        }
      },
      result.baked.tree);
  return result;
}

void print_row(const Result& result, std::size_t width) {
  std::visit(
      [&](const auto& baked) {
        const double per_triangle =
            static_cast<double>(result.flash_bytes) / static_cast<double>(baked.triangles.size());
        std::cout << std::left << std::setw(static_cast<int>(width)) << result.name.stem
                  << std::right << std::setw(10) << baked.triangles.size() << std::setw(10)
                  << baked.vertices.size() << std::setw(8) << baked.nodes.size() << std::setw(7)
                  << baked.depth << std::setw(10) << result.flash_bytes << std::setw(16)
                  << fixed(per_triangle, 1) << std::setw(10) << result.image_bytes << "  "
                  << shortest(baked.deviation) << "\n";
      },
      result.baked.tree);
}

void print(const std::vector<Result>& results, double cell) {
  std::size_t width = 6;
  for (const Result& result : results) {
    width = std::max(width, result.name.stem.size() + 2);
  }
  std::cout << std::left << std::setw(static_cast<int>(width)) << "mesh"
            << " triangles  vertices   nodes  depth     flash  bytes/triangle     image  largest "
               "deviation\n";
  for (const Result& result : results) {
    print_row(result, width);
  }
  std::cout << "cell " << shortest(cell)
            << "; flash: bytes that a query on the C++ output links; image: bytes of the binary\n";
  for (const Result& result : results) {
    if (result.baked.degenerate + result.baked.repeated != 0) {
      std::cout << result.name.stem << ": on the lattice " << result.baked.degenerate
                << " triangles have no area and " << result.baked.repeated
                << " repeat another; all are kept\n";
    }
  }
}

void bake_all(const Arguments& arguments) {
  const std::vector<OutputName> names = output_names(arguments);
  std::vector<bake::SourceMesh> meshes;
  for (const std::string& path : arguments.meshes) {
    meshes.push_back(import_mesh(path));
  }
  const double cell = common_cell(arguments, meshes);
  FileSet files;
  std::vector<Result> results;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    results.push_back(bake_one(arguments, i, meshes[i], cell, names[i], files));
  }
  files.write();
  print(results, cell);
}

}  // namespace

void add_bake(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  Arguments& a = *arguments;
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
  command->add_option("--max-bytes", a.max_bytes, "Refuse to write if an image is larger")
      ->check(CLI::PositiveNumber);
  command->callback([arguments] { bake_all(*arguments); });
}

}  // namespace flashbvh::tool
