// The options of `flashbvh bake`, typed, and what it makes of --simplify and --fit. All checks that
// need no file happen as options are read.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/baking.hpp"
#include "image/output_name.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

struct BakeOrder {
  std::vector<std::string> meshes;
  std::vector<OutputName> names;  ///< one per mesh, all different
  std::string folder;
  bool writes_c = true;
  bool writes_images = true;
  bool levels = false;                    ///< stored in images of post-indexed trees
  bool dry_run = false;                   ///< writes no image
  bool deformable = false;                ///< the default cell leaves space for deformation
  std::optional<double> simplify;         ///< the largest deviation of a simplified mesh
  std::optional<double> fit;              ///< bytes of all images; simplifies as little as needed
  std::vector<std::uint32_t> leaf_sizes;  ///< for --fit
  Units units;
  BakeOptions options;
  bool json = false;  ///< prints the table as an object
};

/// Declares the options; passes their values to `run`. UserError if they contradict each other.
void add_bake_options(CLI::App& command, const std::function<void(const BakeOrder&)>& run);

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
