// Simplifies meshes for --simplify and --fit of `flashbvh bake`.
#pragma once

#include <vector>

#include "cli/mesh/bake_options.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

struct Simplified {
  std::vector<simplify::Coarsening> meshes;  ///< empty: the meshes are baked unchanged
  double length = 0;                         ///< the deviation that they keep
};

/// Simplifies as the order requests; for --fit, sets the leaf size of `options`. UserError if the
/// length is smaller than rounding errors, or the images do not fit. `meshes` must outlive the
/// result.
Simplified simplified_meshes(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                             BakeOptions& options);

}  // namespace flashbvh::tool
