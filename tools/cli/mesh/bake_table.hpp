// What `flashbvh bake` prints: a row a mesh, what firmware links first.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bake/bending.hpp"
#include "cli/json.hpp"
#include "cli/mesh/mesh_warnings.hpp"
#include "mesh/units.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// What one mesh became.
struct BakeRow {
  std::string mesh;
  std::uint64_t flash_bytes = 0;  ///< of the image
  std::size_t triangles = 0;
  std::size_t source_triangles = 0;  ///< of the file
  std::size_t vertices = 0;
  std::size_t nodes = 0;
  std::size_t depth = 0;
  double deviation = 0;
  Size size = {};
  bake::BendingCost bending = {};
};

/// On standard output, with a row for all of them if they are several.
void print_bake_table(const std::vector<BakeRow>& rows, const Units& units);

/// The rows, the cell and the warnings as one JSON object on standard output.
/// `lengths`: of --dry-run, or null.
void print_bake_json(const std::vector<BakeRow>& rows, double cell, const Units& units,
                     const Warnings& warnings, const Json& lengths);

/// What simplifying to `length` did, of all together.
void print_simplified(const std::vector<BakeRow>& rows, double length, std::uint32_t leaf_size,
                      const Units& units);

/// A line a mesh: what it takes to bend.
void print_bending(const std::vector<BakeRow>& rows);

}  // namespace flashbvh::tool
