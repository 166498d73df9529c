#include "cli/mesh/info_mesh.hpp"
#include "bake/image_bytes.hpp"
#include "cli/json.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "cli/mesh/mesh_warnings.hpp"
#include "image/baking.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

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

Json defects_as_json(const MeshDefects& defects) {
  return {{"degenerate", defects.degenerate.size()},
          {"collapsed", defects.collapsed.size()},
          {"duplicate", defects.duplicates.size()},
          {"boundary_edges", defects.edges.boundary},
          {"non_manifold_edges", defects.edges.non_manifold},
          {"twisted_edges", defects.edges.twisted}};
}

/// Names and values, in the order of both outputs.
Json facts_of(const InputMesh& mesh, Warnings& warnings) {
  BakeOptions options;
  options.cell = mesh.finest_cell;
  Json facts = {{"name", mesh.path},
                {"triangles", mesh.mesh.triangles.size()},
                {"vertices", mesh.mesh.vertices.size()},
                {"bodies", mesh.bodies},
                {"box", {{"lower", mesh.extent.low}, {"upper", mesh.extent.high}}},
                {"size", mesh.extent.size()},
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

std::string coordinates_text(const Json& point) {
  std::string text;
  for (const Json& coordinate : point) {
    text += (text.empty() ? "" : " ") + shortest(coordinate.get<double>());
  }
  return text;
}

void print(const Json& facts) {
  const auto line = [](const std::string& name, const std::string& text) {
    std::cout << std::left << std::setw(20) << name << text << "\n";
  };
  line("name", one_line(facts["name"].get<std::string>()));
  line("triangles", facts["triangles"].dump());
  line("vertices", facts["vertices"].dump());
  line("bodies", concat(facts["bodies"].size()));
  line("box", coordinates_text(facts["box"]["lower"]) + "  to  " +
                  coordinates_text(facts["box"]["upper"]));
  line("size", size_text(facts["size"].get<Size>(), ""));
  line("finest cell", shortest(facts["finest_cell"].get<double>()));
  line("deviation", shortest(facts["deviation"].get<double>()));
  for (const Json& flash : facts["flash"]) {
    line("flash, leaf size " + flash["leaf_size"].dump(),
         concat(flash["bytes"].dump(), " bytes, ",
                fixed(flash["bytes_per_triangle"].get<double>(), 1), " a triangle, with ",
                flash["index_bits"].dump(), "-bit indices"));
  }
  line(
      "",
      "larger leaves make the worst pose more expensive: see `collide --bound` on the baked image");
}

}  // namespace

void info_of_mesh(const std::string& path, bool json) {
  Warnings warnings;
  const Json facts = facts_of(read_mesh(path, Units(), warnings), warnings);
  warnings.print();
  if (json) {
    print_object(facts);
  } else {
    print(facts);
  }
}

}  // namespace flashbvh::tool
