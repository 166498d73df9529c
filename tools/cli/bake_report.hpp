// What `flashbvh bake` says of its results.
#ifndef FLASHBVH_TOOLS_CLI_BAKE_REPORT_HPP
#define FLASHBVH_TOOLS_CLI_BAKE_REPORT_HPP

#include <string>
#include <vector>

#include "image/baking.hpp"
#include "image/output_name.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// What one mesh became.
struct BakeResult {
  OutputName name;
  BakedMesh baked;
  std::size_t image_bytes;
  std::size_t flash_bytes;
};

/// A row for each mesh. `cell`: with its unit.
void print_table(const std::vector<BakeResult>& results, const std::string& cell);

/// What the user may not know of the mesh in `path`.
void warn_of_defects(const MeshDefects& defects, const BakeOptions& options,
                     const std::string& path, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
