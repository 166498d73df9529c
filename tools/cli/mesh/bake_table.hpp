// The output of `flashbvh bake`: one row per mesh, from the fields of --json; the first columns
// concern firmware.
#pragma once

#include "cli/json.hpp"
#include "mesh/units.hpp"

namespace flashbvh::tool {

/// Prints to standard output, with a row of totals if there are several meshes.
void print_bake_table(const Json& meshes, const Units& units);

/// Prints the effect of simplifying to `length`, for all meshes together.
void print_simplified(const Json& meshes, double length, std::uint32_t leaf_size,
                      const Units& units);

/// Prints a line per mesh with the cost of deforming it.
void print_bending(const Json& meshes);

}  // namespace flashbvh::tool
