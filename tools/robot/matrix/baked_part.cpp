#include "robot/matrix/baked_part.hpp"

#include "image/baking.hpp"

namespace flashbvh::tool {

BakedPart bake_part(const InputMesh& mesh, double cell, std::uint32_t leaf_size) {
  BakeOptions options;
  options.unit = "m";
  options.index_width = IndexWidth::bits_32;
  options.leaf_size = leaf_size;
  options.cell = cell;
  return std::get<BakedPart>(bake(mesh, options).tree);
}

BakedPart bake_part(const bake::SourceMesh& mesh, double cell) {
  return bake_part(input_of("", mesh), cell, bake::kDefaultLeafSize);
}

std::vector<WholeMesh> views_of(const std::vector<BakedPart>& parts) {
  std::vector<WholeMesh> views;
  views.reserve(parts.size());
  for (const BakedPart& part : parts) {
    views.push_back(part.view());
  }
  return views;
}

}  // namespace flashbvh::tool
