// What assimp would misread in silence is refused by its name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

struct GltfContents {
  std::uint64_t triangles = 0;  ///< of the scene's nodes
  std::vector<std::string> warnings;
};

/// The bytes of a .gltf or .glb. UserError for what is not read, such as a skin, morph targets, a
/// sparse accessor, positions that are no floats, and most extensions; for data that end too early.
GltfContents check_gltf(std::string_view bytes, const std::string& file);

/// UserError for skins, morphs, kinds of geometry and transforms that are not read; references to
/// nothing; a unit that is no length; malformed XML.
void check_collada(std::string_view text, const std::string& file);

}  // namespace flashbvh::tool
