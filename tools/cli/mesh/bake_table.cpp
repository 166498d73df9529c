#include "cli/mesh/bake_table.hpp"

#include <algorithm>
#include <iostream>

#include "cli/table.hpp"
#include "image/mesh_warnings.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

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

}  // namespace

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
            << ", leaves of " << leaf_size << "; every point within " << units.with_unit(length)
            << " of the file's mesh, and the other way round; triangles are numbered again\n";
}

void print_bending(const Json& meshes) {
  for (const Json& mesh : meshes) {
    std::cout << mesh["name"].get<std::string>() << " bends in " << mesh["ram_to_bend"]
              << " bytes of RAM; a refit takes about " << mesh["refit_instructions"]
              << " instructions on a Cortex-M4F\n";
  }
}

}  // namespace flashbvh::tool
