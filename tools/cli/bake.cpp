// flashbvh bake: everything is read and baked before the first file is written.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numeric>

#include "bake/image_bytes.hpp"
#include "cli/bake_options.hpp"
#include "cli/bake_table.hpp"
#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "cli/surface.hpp"
#include "image/c_writer.hpp"
#include "image/cpp_writer.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

/// "kept; --drop degenerate leaves them out", or that they were.
std::string fate(bool dropped, const char* kind) {
  return dropped ? "; left out" : std::string("; kept (--drop ") + kind + " leaves them out)";
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
  warn_of_surface(defects, path, warnings);
}

void check_size(const BakeOrder& order, const std::string& mesh, std::uint64_t bytes) {
  if (order.writes_images && bytes > 0xFFFFFFFFu) {
    throw UserError(mesh, "the image would be over 4 GiB; use fewer triangles");
  }
  if (order.writes_c && bytes > 0x7FFFFFFFu) {
    throw UserError(mesh, "the C array would be over 2 GiB; use --format image or fewer triangles");
  }
  if (order.max_bytes && static_cast<std::int64_t>(bytes) > *order.max_bytes) {
    throw UserError(mesh, "takes ", bytes, " bytes, --max-bytes allows ", *order.max_bytes,
                    "; use a larger --leaf-size or fewer triangles");
  }
}

/// The files of a mesh, whatever the format.
template <class Baked>
void add_files(const Baked& baked, const BakeOrder& order, const OutputName& name, FileSet& files) {
  const std::string stem = (std::filesystem::path(order.folder) / name.stem).string();
  const auto add = [&](const char* extension, std::string bytes) {
    refuse_to_replace_inputs(stem + extension, order.meshes);
    files.add(stem + extension, std::move(bytes));
  };
  if (order.writes_images) {
    const std::vector<std::uint32_t> words = image_of(baked, order.levels);
    add(".fbvh", {reinterpret_cast<const char*>(words.data()), words.size() * sizeof words[0]});
  }
  if (order.writes_cpp) {
    CppFiles cpp = cpp_of(baked, name, order.units.common());
    add(".fbvh.hpp", std::move(cpp.header));
    add(".fbvh.cpp", std::move(cpp.source));
  }
  if (order.writes_c) {
    CFiles c = c_of(baked, image_of(baked, order.levels), name, order.units.common());
    add(".fbvh.h", std::move(c.header));
    add(".fbvh.c", std::move(c.source));
  }
}

BakeRow bake_one(const BakeOrder& order, BakedMesh& mesh, const std::string& path,
                 const OutputName& name, FileSet& files) {
  return std::visit(
      [&](auto& baked) {
        baked.unit = order.units.unit();
        baked.name = name.stem.substr(0, bake::kMaxNameSize);
        const std::size_t image = image_size(baked, order.levels);
        check_size(order, path, image);
        if (!order.dry_run) {
          add_files(baked, order, name, files);
        }
        return BakeRow{name.stem,
                       order.writes_cpp ? flash_bytes(baked) : image,
                       image,
                       baked.triangles.size(),
                       baked.vertices.size(),
                       baked.nodes.size(),
                       baked.depth,
                       baked.deviation};
      },
      mesh.tree);
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

/// Everything but what is written. `options`: the order's, with the cell that all the meshes share.
std::vector<BakeRow> bake_meshes(const BakeOrder& order, BakeOptions& options, FileSet& files,
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
  std::vector<BakeRow> rows;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    progress.begin("baking " + meshes[i].path, weights[i]);
    BakedMesh baked = bake(meshes[i], options);
    rows.push_back(bake_one(order, baked, meshes[i].path, order.names[i], files));
    warn_of_defects(baked.defects, options, meshes[i].path, warnings);
  }
  return rows;
}

const char* legend(const BakeOrder& order) {
  return order.writes_cpp ? "; flash: bytes that a query on the C++ arrays links; image: bytes of "
                            "the binary\n"
         : order.writes_c ? "; flash: bytes of the C array, which is the image\n"
                          : "; flash: bytes of the image\n";
}

void bake_all(const BakeOrder& order) {
  Warnings warnings;
  BakeOptions options = order.options;
  FileSet files;
  const std::vector<BakeRow> rows = bake_meshes(order, options, files, warnings);
  // Files that nobody heard of are none: what prints fails before they are in place.
  files.write([&] {
    warnings.print();
    print_bake_table(rows, order.units);
    std::cout << "cell " << order.units.with_unit(*options.cell) << legend(order);
    flush_output();
  });
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "bake",
      "Bake meshes (STL, OBJ, PLY, OFF) into trees: C++ arrays, C arrays and binary images.\n"
      "Meshes that are queried together share a cell: bake them in one call.");
  add_bake_options(*command, bake_all);
}

}  // namespace flashbvh::tool
