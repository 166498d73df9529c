// What --simplify, --fit and --dry-run of `flashbvh bake` make of meshes.
#pragma once

#include <vector>

#include "cli/mesh/bake_options.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

struct Simplified {
  std::vector<simplify::Coarsening> meshes;  ///< none: to be baked as they are
  double length = 0;                         ///< within which they keep
};

/// As the order says; sets the leaf size of `options` for --fit. UserError if it is less than
/// rounding moves, or they do not fit. `meshes` outlive what is made of them. `names`: of the
/// images.
Simplified simplified_meshes(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                             const std::vector<std::string>& names, BakeOptions& options);

/// What lengths cost, for lengths up to kLongestPart of the largest mesh.
std::vector<simplify::LengthRow> lengths_of(const BakeOrder& order,
                                            const std::vector<InputMesh>& meshes,
                                            const std::vector<std::string>& names,
                                            const BakeOptions& options);

/// Of its columns.
std::vector<std::uint32_t> shown_leaf_sizes(const BakeOrder& order);

}  // namespace flashbvh::tool
