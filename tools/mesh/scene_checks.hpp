// What a reader would misread in silence is refused by its name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// True for an extension of glTF, or of 3MF by its namespace, that does not change the geometry,
/// or that its reader checks.
bool is_understood(std::string_view extension);

struct GltfContents {
  std::uint64_t triangles = 0;  ///< of the scene's nodes
  std::vector<std::string> warnings;
};

/// The bytes of a .gltf or .glb. UserError for an extension that is not understood where it may
/// change the geometry, or is required; a skin; morph weights; positions that are no floats; a
/// sparse accessor; one that ends behind its data.
GltfContents check_gltf(std::string_view bytes, const std::string& file);

/// UserError for skins, morphs, kinds of geometry and transforms that are not read; references to
/// nothing; a unit that is no length.
void check_collada(std::string_view text, const std::string& file);

}  // namespace flashbvh::tool
