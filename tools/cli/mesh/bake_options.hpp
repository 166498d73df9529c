// The options of `flashbvh bake`, typed: all that can be refused before a file is read is refused
// here.
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
  bool split = false;             ///< each body of a mesh is baked apart
  std::vector<OutputName> names;  ///< of each mesh, all different; none if they are split
  std::string folder;
  bool writes_c = true;
  bool writes_images = true;
  bool levels = false;                    ///< in images of post-indexed trees
  bool dry_run = false;                   ///< writes nothing at all
  bool deformable = false;                ///< the default cell leaves room to bend
  std::optional<std::int64_t> max_bytes;  ///< of an image
  std::optional<double> simplify;         ///< how far a simplified mesh may deviate
  std::optional<std::int64_t> fit;  ///< what all images may take: as little simplified as that
  bool has_leaf_size = false;       ///< the user chose it
  Units units;
  BakeOptions options;
  std::string page;       ///< or empty
  bool progress = false;  ///< a bar at once
  bool json = false;      ///< the table as an object
};

/// Declares them; `run` gets what they say. UserError if they make no sense.
void add_bake_options(CLI::App& command, const std::function<void(const BakeOrder&)>& run);

}  // namespace flashbvh::tool
