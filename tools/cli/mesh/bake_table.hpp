// The output of `flashbvh bake`: one row per mesh; the first columns concern firmware.
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

/// A baked mesh.
struct BakeRow {
  std::string mesh;
  std::uint64_t flash_bytes = 0;  ///< size of the image
  std::size_t triangles = 0;
  std::size_t source_triangles = 0;  ///< in the file
  std::size_t vertices = 0;
  std::size_t nodes = 0;
  std::size_t depth = 0;
  double deviation = 0;
  Size size = {};
  bake::BendingCost bending = {};
};

/// Prints to standard output, with a row of totals if there are several meshes.
void print_bake_table(const std::vector<BakeRow>& rows, const Units& units);

/// Prints the rows, the cell and the warnings as one JSON object to standard output.
void print_bake_json(const std::vector<BakeRow>& rows, double cell, const Units& units,
                     const Warnings& warnings);

/// Prints the effect of simplifying to `length`, for all meshes together.
void print_simplified(const std::vector<BakeRow>& rows, double length, std::uint32_t leaf_size,
                      const Units& units);

/// Prints a line per mesh with the cost of deforming it.
void print_bending(const std::vector<BakeRow>& rows);

}  // namespace flashbvh::tool
