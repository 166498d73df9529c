// flashbvh bake: everything is read and baked before the first file is written.
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <set>

#include "bake/image_bytes.hpp"
#include "cli/bake_options.hpp"
#include "cli/commands.hpp"
#include "cli/mesh_warnings.hpp"
#include "cli/progress.hpp"
#include "image/cpp_writer.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// What one mesh became.
struct BakeResult {
  OutputName name;
  BakedMesh baked;
  std::size_t image_bytes;
  std::size_t flash_bytes;
};

void print_row(const BakeResult& result, std::size_t width) {
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

void print_table(const std::vector<BakeResult>& results, const std::string& cell) {
  std::size_t width = 6;
  for (const BakeResult& result : results) {
    width = std::max(width, result.name.stem.size() + 2);
  }
  std::cout << std::left << std::setw(static_cast<int>(width)) << "mesh"
            << " triangles  vertices   nodes  depth     flash  bytes/triangle     image  largest "
               "deviation\n";
  for (const BakeResult& result : results) {
    print_row(result, width);
  }
  std::cout << "cell " << cell
            << "; flash: bytes that a query on the C++ output links; image: bytes of the binary\n";
}

void check_budget(const BakeOrder& order, const std::string& mesh, std::size_t bytes) {
  if (order.max_bytes && static_cast<std::int64_t>(bytes) > *order.max_bytes) {
    throw UserError(mesh, "takes ", bytes, " bytes, --max-bytes allows ", *order.max_bytes,
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

BakeResult bake_one(const BakeOrder& order, const BakeOptions& options, const InputMesh& mesh,
                    const OutputName& name, FileSet& files) {
  BakeResult result = {name, bake(mesh, options), 0, 0};
  const std::string stem = (std::filesystem::path(order.folder) / name.stem).string();
  std::visit(
      [&](const auto& baked) {
        result.image_bytes = image_size(baked);
        result.flash_bytes = flash_bytes(baked);
        check_budget(order, mesh.path, result.image_bytes);
        if (order.writes_images) {
          files.add(stem + ".fbvh", image_file(baked, mesh.path));
        }
        if (order.writes_cpp) {
          CppFiles cpp = cpp_of(baked, name, order.units.common());
          files.add(stem + ".fbvh.hpp", std::move(cpp.header));
          files.add(stem + ".fbvh.cpp", std::move(cpp.source));
        }
      },
      result.baked.tree);
  return result;
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

/// A mesh file, or one of its bodies.
struct Part {
  InputMesh mesh;
  OutputName name;
  double weight;
};

std::vector<Part> read_parts(const BakeOrder& order, const std::vector<double>& weights,
                             Progress& progress, Warnings& warnings) {
  std::vector<Part> parts;
  std::set<std::string> taken;
  for (std::size_t i = 0; i < order.meshes.size(); ++i) {
    const std::string& path = order.meshes[i];
    progress.begin("reading " + path, weights[i]);
    if (!order.split) {
      parts.push_back({read_mesh(path, order.units, warnings), order.names[i], weights[i]});
      continue;
    }
    std::vector<InputMesh> bodies = read_bodies(path, order.units, warnings);
    const std::vector<OutputName> names = body_names(path, bodies);
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (!taken.insert(names[j].identifier).second) {
        throw UserError(bodies[j].path, "would be written as '", names[j].identifier,
                        "' like one of a mesh before it; bake the files into folders of their own");
      }
      parts.push_back(
          {std::move(bodies[j]), names[j], weights[i] / static_cast<double>(bodies.size())});
    }
  }
  return parts;
}

/// Everything but the reports. `options`: the order's, with the cell that all the meshes share.
std::vector<BakeResult> bake_and_write(const BakeOrder& order, BakeOptions& options,
                                       Warnings& warnings) {
  const std::vector<double> weights = weights_of(order.meshes);
  Progress progress(2 * std::accumulate(weights.begin(), weights.end(), 0.0), order.progress);
  const std::vector<Part> parts = read_parts(order, weights, progress, warnings);
  double finest = 0;
  for (const Part& part : parts) {
    finest = std::max(finest, finest_cell(part.mesh));
  }
  options.cell = order.options.cell.value_or(finest);
  FileSet files;
  std::vector<BakeResult> results;
  for (const Part& part : parts) {
    progress.begin("baking " + part.mesh.path, part.weight);
    results.push_back(bake_one(order, options, part.mesh, part.name, files));
    warn_of_mesh(part.mesh, results.back().baked.defects, options, warnings);
  }
  progress.begin("writing " + order.folder, 0);
  files.write();
  return results;
}

void bake_all(const BakeOrder& order) {
  Warnings warnings;
  BakeOptions options = order.options;
  const std::vector<BakeResult> results = bake_and_write(order, options, warnings);
  warnings.print();
  print_table(results, order.units.with_unit(*options.cell));
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "bake", concat("Bake meshes (", kMeshFormats,
                     ")\ninto trees: C++ arrays and binary images.\n"
                     "Meshes that are queried together share a cell: bake them in one call."));
  add_bake_options(*command, bake_all);
}

}  // namespace flashbvh::tool
