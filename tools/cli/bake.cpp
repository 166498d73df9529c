// flashbvh bake: everything is read and baked before the first file is written.
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <numeric>

#include "bake/image_bytes.hpp"
#include "cli/bake_options.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "image/cpp_writer.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// What one mesh became.
struct BakeResult {
  const OutputName* name;
  BakedMesh baked;
  std::size_t image_bytes;
  std::size_t flash_bytes;
};

void print_row(const BakeResult& result, std::size_t width) {
  std::visit(
      [&](const auto& baked) {
        const double per_triangle =
            static_cast<double>(result.flash_bytes) / static_cast<double>(baked.triangles.size());
        std::cout << std::left << std::setw(static_cast<int>(width)) << result.name->stem
                  << std::right << std::setw(10) << baked.triangles.size() << std::setw(10)
                  << baked.vertices.size() << std::setw(8) << baked.nodes.size() << std::setw(7)
                  << baked.depth << std::setw(10) << result.flash_bytes << std::setw(16)
                  << fixed(per_triangle, 1) << std::setw(10) << result.image_bytes << "  "
                  << shortest(baked.deviation) << "\n";
      },
      result.baked.tree);
}

/// "kept; --drop degenerate leaves them out", or that they were.
std::string fate(bool dropped, const char* kind) {
  return dropped ? "; left out" : std::string("; kept (--drop ") + kind + " leaves them out)";
}

std::string edge_text(const EdgeDefects& edges) {
  std::string text;
  const auto add = [&](std::size_t count, const char* kind, const char* what) {
    if (count != 0) {
      text += concat((text.empty() ? "" : ", "), count, " ", kind,
                     (count == 1 ? "edge " : "edges "), what);
    }
  };
  add(edges.boundary, "boundary ", "of one triangle");
  add(edges.non_manifold, "non-manifold ", "of more than two");
  add(edges.twisted, "", "of two that face opposite ways");
  return text;
}

void print_table(const std::vector<BakeResult>& results, const std::string& cell) {
  std::size_t width = 6;
  for (const BakeResult& result : results) {
    width = std::max(width, result.name->stem.size() + 2);
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

void warn_of_defects(const MeshDefects& defects, const BakeOptions& options,
                     const std::string& path, Warnings& warnings) {
  const auto warn = [&](const TriangleIds& triangles, const char* what, bool dropped,
                        const char* kind) {
    if (!triangles.empty()) {
      warnings.add(path, what + triangle_list(triangles) + fate(dropped, kind));
    }
  };
  warn(defects.degenerate, "without area: ", options.drop_degenerate, "degenerate");
  warn(defects.collapsed, "without area once rounded: ", options.drop_degenerate, "degenerate");
  warn(defects.duplicates,
       "with the three vertices of an earlier one, once rounded: ", options.drop_duplicate,
       "duplicate");
  if (!defects.edges.none()) {
    warnings.add(path, std::string(defects.closed_before ? "once rounded " : "") +
                           "no closed surface (" + edge_text(defects.edges) +
                           "): what lies inside the solid can't be told" +
                           (defects.closed_before ? "; a finer --cell keeps it closed" : ""));
  }
}

void check_budget(const BakeOrder& order, const std::string& mesh, std::size_t bytes) {
  if (order.max_bytes && static_cast<std::int64_t>(bytes) > *order.max_bytes) {
    throw UserError(mesh, "takes ", bytes, " bytes, --max-bytes allows ", *order.max_bytes,
                    "; use a larger --leaf-size or fewer triangles");
  }
}

template <class Baked>
std::string image_file(const Baked& baked, const std::string& path, bool levels) {
  if (image_size(baked, levels) > 0xFFFFFFFFu) {
    throw UserError(path, "the image would be over 4 GiB; use fewer triangles");
  }
  const std::vector<std::uint32_t> words = image_of(baked, levels);
  return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]};
}

BakeResult bake_one(const BakeOrder& order, const BakeOptions& options, const InputMesh& mesh,
                    const OutputName& name, FileSet& files) {
  BakeResult result = {&name, bake(mesh, options), 0, 0};
  const std::string stem = (std::filesystem::path(order.folder) / name.stem).string();
  std::visit(
      [&](auto& baked) {
        baked.unit = order.units.unit();
        baked.name = name.stem.substr(0, bake::kMaxNameSize);
        result.image_bytes = image_size(baked, order.levels);
        result.flash_bytes = flash_bytes(baked);
        check_budget(order, mesh.path, result.image_bytes);
        if (order.writes_images) {
          files.add(stem + ".fbvh", image_file(baked, mesh.path, order.levels));
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

/// Everything but the reports. `options`: the order's, with the cell that all the meshes share.
std::vector<BakeResult> bake_and_write(const BakeOrder& order, BakeOptions& options,
                                       Warnings& warnings) {
  const std::vector<double> weights = weights_of(order.meshes);
  Progress progress(2 * std::accumulate(weights.begin(), weights.end(), 0.0), order.progress);
  std::vector<InputMesh> meshes;
  double finest = 0;
  for (const std::string& path : order.meshes) {
    progress.begin("reading " + path, weights[meshes.size()]);
    meshes.push_back(read_mesh(path, order.units, warnings));
    finest = std::max(finest, finest_cell(meshes.back()));
  }
  options.cell = order.options.cell.value_or(finest);
  FileSet files;
  std::vector<BakeResult> results;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    progress.begin("baking " + meshes[i].path, weights[i]);
    results.push_back(bake_one(order, options, meshes[i], order.names[i], files));
    warn_of_defects(results.back().baked.defects, options, meshes[i].path, warnings);
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
      "bake",
      "Bake meshes (STL, OBJ, PLY, OFF) into trees: C++ arrays and binary images.\n"
      "Meshes that are queried together share a cell: bake them in one call.");
  add_bake_options(*command, bake_all);
}

}  // namespace flashbvh::tool
