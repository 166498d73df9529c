// The options of `flashbvh bake`, typed. All checks that need no file happen here.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/baking.hpp"
#include "image/output_name.hpp"

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

}  // namespace flashbvh::tool
