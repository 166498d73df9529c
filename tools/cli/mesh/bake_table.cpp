#include "cli/mesh/bake_table.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/json.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The sum of bytes and counts, the largest depth and the largest deviation.
BakeRow total_of(const std::vector<BakeRow>& rows) {
  BakeRow total;
  total.mesh = "total";
  for (const BakeRow& row : rows) {
    total.flash_bytes += row.flash_bytes;
    total.triangles += row.triangles;
    total.vertices += row.vertices;
    total.nodes += row.nodes;
    total.depth = std::max(total.depth, row.depth);
    total.deviation = std::max(total.deviation, row.deviation);
  }
  return total;
}

void print_row(const BakeRow& row, int width, const Units& units, bool is_total) {
  const double per_triangle =
      static_cast<double>(row.flash_bytes) / static_cast<double>(row.triangles);
  std::cout << std::left << std::setw(width) << row.mesh << std::right << std::setw(10)
            << row.flash_bytes << std::setw(16) << fixed(per_triangle, 1) << std::setw(11)
            << row.triangles << std::setw(10) << row.vertices << std::setw(8) << row.nodes
            << std::setw(7) << row.depth << "  ";
  const std::string deviation =
      significant(row.deviation, 4) + (units.common().empty() ? "" : " " + units.common());
  if (is_total) {
    std::cout << deviation << "\n";
    return;
  }
  std::cout << std::left << std::setw(18) << deviation << std::right
            << size_text(row.size, units.common()) << "\n";
}

}  // namespace

void print_bake_table(const std::vector<BakeRow>& rows, const Units& units) {
  std::size_t widest = 5;  // "total"
  for (const BakeRow& row : rows) {
    widest = std::max(widest, row.mesh.size());
  }
  const int width = static_cast<int>(widest) + 1;
  std::cout << std::left << std::setw(width) << "mesh"
            << "     flash  bytes/triangle  triangles  vertices   nodes  depth  largest "
               "deviation size\n";
  for (const BakeRow& row : rows) {
    print_row(row, width, units, false);
  }
  if (rows.size() > 1) {
    print_row(total_of(rows), width, units, true);
  }
}

void print_bake_json(const std::vector<BakeRow>& rows, double cell, const Units& units,
                     const Warnings& warnings) {
  Json all = {{"unit", units.common()}, {"cell", cell}, {"meshes", Json::array()}};
  for (const BakeRow& row : rows) {
    all["meshes"].push_back({{"name", row.mesh},
                             {"flash_bytes", row.flash_bytes},
                             {"triangles", row.triangles},
                             {"source_triangles", row.source_triangles},
                             {"vertices", row.vertices},
                             {"nodes", row.nodes},
                             {"depth", row.depth},
                             {"deviation", row.deviation},
                             {"size", row.size},
                             {"ram_to_bend", row.bending.ram_bytes},
                             {"refit_instructions", row.bending.refit_instructions}});
  }
  all["warnings"] = json_of(warnings);
  print_object(all);
}

void print_simplified(const std::vector<BakeRow>& rows, double length, std::uint32_t leaf_size,
                      const Units& units) {
  std::size_t before = 0;
  std::size_t after = 0;
  for (const BakeRow& row : rows) {
    before += row.source_triangles;
    after += row.triangles;
  }
  std::cout << "simplified: " << before << " triangles -> " << after << ", leaves of " << leaf_size
            << "; every point within " << units.with_unit(length)
            << " of the file's mesh, and the other way round; triangles are numbered again\n";
}

void print_bending(const std::vector<BakeRow>& rows) {
  for (const BakeRow& row : rows) {
    std::cout << row.mesh << " bends in " << row.bending.ram_bytes
              << " bytes of RAM; a refit takes about " << row.bending.refit_instructions
              << " instructions on a Cortex-M4F\n";
  }
}

}  // namespace flashbvh::tool
