// flashbvh bake: reads and bakes all meshes before it writes the first file.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "bake/bending.hpp"
#include "bake/image_bytes.hpp"
#include "cli/commands.hpp"
#include "cli/mesh/bake_options.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "image/c_writer.hpp"
#include "image/mesh_warnings.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

void check_size(const BakeOrder& order, const std::string& mesh, std::uint64_t bytes) {
  if (order.writes_images && bytes > 0xFFFFFFFFu) {
    throw UserError(mesh, "the image would be over 4 GiB; simplify it: --simplify, --fit");
  }
  if (order.writes_c && bytes > 0x7FFFFFFFu) {
    throw UserError(mesh,
                    "the array would be over 2 GiB; use --format image, or simplify it: "
                    "--simplify, --fit");
  }
}

/// Adds the files of a mesh, in each requested format.
template <class Baked>
void add_files(const Baked& baked, const BakeOrder& order, const OutputName& name, FileSet& files) {
  const std::string stem = (std::filesystem::path(order.folder) / name.stem).string();
  const std::vector<std::uint32_t> words = image_of(baked, order.levels);
  if (order.writes_images) {
    files.add(stem + ".fbvh", as_bytes(words));
  }
  if (order.writes_c) {
    SourceFiles c = mesh_in_c(words, name, order.units.common());
    files.add(stem + ".fbvh.h", std::move(c.header));
    files.add(stem + ".fbvh.c", std::move(c.source));
  }
}

/// Adds the mesh's files, and returns what --json prints of it.
Json bake_one(const BakeOrder& order, BakedMesh& mesh, const InputMesh& input,
              const OutputName& name, FileSet& files) {
  return std::visit(
      [&](auto& baked) {
        if (order.deformable) {
          bake::show_quads(baked);
          baked.slabs.clear();  // they do not bend
        }
        baked.unit = order.units.unit();
        baked.name = name.stem.substr(0, bake::kMaxNameSize);
        const std::uint64_t image = image_size(baked, order.levels);
        check_size(order, input.path, image);
        if (!order.dry_run) {
          add_files(baked, order, name, files);
        }
        const bake::BendingCost bending = bake::bending_cost(baked.view());
        return Json{{"name", name.stem},
                    {"flash_bytes", image},
                    {"triangles", baked.triangles.size()},
                    {"source_triangles", input.mesh.triangles.size()},
                    {"vertices", baked.vertices.size()},
                    {"nodes", baked.nodes.size()},
                    {"depth", baked.depth},
                    {"deviation", baked.deviation},
                    {"size", input.extent.size()},
                    {"ram_to_bend", bending.ram_bytes},
                    {"refit_instructions", bending.refit_instructions}};
      },
      mesh.tree);
}

std::vector<InputMesh> read_meshes(const BakeOrder& order, Progress& progress, Warnings& warnings) {
  std::vector<InputMesh> meshes;
  for (const std::string& path : order.meshes) {
    progress.begin("reading " + path, 1);
    meshes.push_back(read_mesh(path, order.units, warnings));
  }
  if (order.units.common().empty()) {
    check_units(meshes, warnings);
  }
  return meshes;
}

/// Warns of meshes that seem to be in another unit than the others.
void warn_of_odd_sizes(const std::vector<InputMesh>& meshes, const std::string& unit,
                       Warnings& warnings) {
  std::vector<Size> sizes(meshes.size());
  std::transform(meshes.begin(), meshes.end(), sizes.begin(),
                 [](const InputMesh& mesh) { return mesh.extent.size(); });
  for (const OddSize& odd : odd_sizes(sizes)) {
    warnings.add(
        meshes[odd.which].path,
        concat("is ", size_text(sizes[odd.which], unit), ", ", odd_size_text(odd, "meshes"),
               "; if its unit or its scale is another one, --unit FILE=UNIT converts it"));
  }
}

/// Warns of a mesh that is so wide in metres that its numbers may be millimetres.
void warn_of_metres(const InputMesh& mesh, const Units& units, Warnings& warnings) {
  const Size size = mesh.extent.size();
  if (units.common() == "m" && longest_side(size) > 32) {  // so that its cells have a millimetre
    warnings.add(mesh.path,
                 concat("is ", size_text(size, "m"), ", whose finest cell is ",
                        significant(mesh.finest_cell, 3), " m; if it is in mm, add --unit ",
                        mesh.path, "=mm, else cut it in parts for finer cells"));
  }
}

/// The width of a deformable mesh's lattice, as a multiple of the mesh's width.
constexpr double kRoomToBend = 2;

/// The results of a call, for the output.
struct Outcome {
  Json meshes = Json::array();
  double simplified = 0;  ///< the allowed deviation
};

/// Does all the work except writing. `options`: the order's, completed with the cell that all
/// meshes share and the leaf size that fits.
Outcome bake_meshes(const BakeOrder& order, BakeOptions& options, FileSet& files,
                    Warnings& warnings) {
  const auto count = static_cast<double>(order.meshes.size());
  const bool simplifies = order.simplify || order.fit;
  Progress progress((simplifies ? 3 : 2) * count);
  const std::vector<InputMesh> meshes = read_meshes(order, progress, warnings);
  double finest = 0;
  for (const InputMesh& mesh : meshes) {
    finest = std::max(finest, mesh.finest_cell);
  }
  options.cell = order.options.cell.value_or(order.deformable ? kRoomToBend * finest : finest);
  Outcome outcome;
  if (simplifies) {
    progress.begin("simplifying", count);
  }
  const Simplified simplified = simplified_meshes(order, meshes, options);
  outcome.simplified = simplified.length;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const InputMesh& mesh = meshes[i];
    progress.begin("baking " + mesh.path, 1);
    warn_of_metres(mesh, order.units, warnings);
    BakedMesh baked =
        simplified.meshes.empty() ? bake(mesh, options) : bake(mesh, options, simplified.meshes[i]);
    outcome.meshes.push_back(bake_one(order, baked, mesh, order.names[i], files));
    warn_of_mesh(mesh, baked.defects, options, warnings);
    if (baked.dropped > *options.cell / 16) {
      warnings.add(mesh.path,
                   concat("triangles left out lie up to ", order.units.with_unit(baked.dropped),
                          " from all others: the deviation includes that"));
    }
    std::visit([&](const auto& tree) { warn_of_place(tree.origin, mesh.path, warnings); },
               baked.tree);
  }
  warn_of_odd_sizes(meshes, order.units.common(), warnings);
  return outcome;
}

/// The sum of bytes and counts, the largest depth and the largest deviation.
Json total_of(const Json& meshes) {
  Json total = {{"name", "total"}, {"depth", 0}, {"deviation", 0.0}};
  for (const char* const field :
       {"flash_bytes", "triangles", "source_triangles", "vertices", "nodes"}) {
    std::uint64_t sum = 0;
    for (const Json& mesh : meshes) {
      sum += mesh[field].get<std::uint64_t>();
    }
    total[field] = sum;
  }
  for (const Json& mesh : meshes) {
    total["depth"] = std::max(total["depth"], mesh["depth"]);
    total["deviation"] = std::max(total["deviation"], mesh["deviation"]);
  }
  return total;
}

/// One row per mesh, from the fields of --json; the first columns concern firmware.
void print_bake_table(const Json& meshes, const Units& units) {
  Json rows = meshes;
  if (meshes.size() > 1) {
    rows.push_back(total_of(meshes));
  }
  const auto per_triangle = [](const Json& row) {
    return fixed(row["flash_bytes"].get<double>() / row["triangles"].get<double>(), 1);
  };
  const std::string unit = units.common().empty() ? "" : " " + units.common();
  const auto deviation = [&](const Json& row) {
    return significant(row["deviation"].get<double>(), 4) + unit;
  };
  const auto size = [&](const Json& row) {
    return row.contains("size") ? size_text(row["size"].get<Size>(), units.common()) : "";
  };
  print_table(rows, {word_column("mesh", "name"),
                     number_column("flash", "flash_bytes"),
                     {"bytes/triangle", per_triangle, true},
                     number_column("triangles", "triangles"),
                     number_column("vertices", "vertices"),
                     number_column("nodes", "nodes"),
                     number_column("depth", "depth"),
                     {"largest deviation", deviation},
                     {"size", size}});
}

void print_simplified(const Json& meshes, double length, std::uint32_t leaf_size,
                      const Units& units) {
  const Json total = total_of(meshes);
  std::cout << "simplified: " << total["source_triangles"] << " triangles -> " << total["triangles"]
            << ", leaves of " << bake::most_in_leaf(leaf_size) << "; every point within "
            << units.with_unit(length)
            << " of the file's mesh, and the other way round; triangles are numbered again\n";
}

void print_bending(const Json& meshes) {
  for (const Json& mesh : meshes) {
    std::cout << mesh["name"].get<std::string>() << " bends in " << mesh["ram_to_bend"]
              << " bytes of RAM; a refit takes about " << mesh["refit_instructions"]
              << " instructions on a Cortex-M4F\n";
  }
}

void print_outcome(const BakeOrder& order, const BakeOptions& options, const Outcome& outcome,
                   const Warnings& warnings) {
  if (order.json) {
    print_object({{"unit", order.units.common()},
                  {"cell", *options.cell},
                  {"meshes", outcome.meshes},
                  {"warnings", json_of(warnings)}});
    return;
  }
  print_bake_table(outcome.meshes, order.units);
  std::cout << "cell " << order.units.with_unit(*options.cell) << "; flash: bytes of the image\n";
  if (outcome.simplified > 0) {
    print_simplified(outcome.meshes, outcome.simplified, options.leaf_size, order.units);
  }
  if (order.deformable) {
    print_bending(outcome.meshes);
  }
}

void bake_all(const BakeOrder& order) {
  Warnings warnings;
  BakeOptions options = order.options;
  FileSet files(order.meshes);
  const Outcome outcome = bake_meshes(order, options, files, warnings);
  // Prints before renaming: if output fails, no file is left behind.
  files.write([&] {
    warnings.print();
    print_outcome(order, options, outcome, warnings);
  });
}

}  // namespace

void add_bake(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "bake", concat("Bake meshes (", kMeshFormats,
                     ")\ninto images: arrays of C and C++, and binary files.\n"
                     "Meshes that are queried together share a cell: bake them in one call."));
  add_example(*command, "bake plate.obj peg.obj --unit mm -o baked",
              "writes baked/plate.fbvh, its C and C++, and peg's");
  add_bake_options(*command, bake_all);
}

}  // namespace flashbvh::tool
