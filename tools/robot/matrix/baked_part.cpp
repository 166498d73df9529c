#include "robot/matrix/baked_part.hpp"

#include <map>

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
  InputMesh input;
  input.mesh = mesh;
  return bake_part(input, cell, bake::kDefaultLeafSize);
}

std::vector<WholeMesh> views_of(const std::vector<BakedPart>& parts) {
  std::vector<WholeMesh> views;
  views.reserve(parts.size());
  for (const BakedPart& part : parts) {
    views.push_back(part.view());
  }
  return views;
}

bake::SourceMesh part_of(const bake::SourceMesh& mesh,
                         const std::vector<std::uint32_t>& triangles) {
  bake::SourceMesh part;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (const std::uint32_t number : triangles) {
    bake::TriangleCorners corners = mesh.triangles[number];
    for (std::uint32_t& corner : corners) {
      const auto [place, is_new] =
          numbers.try_emplace(corner, static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) {
        part.vertices.push_back(mesh.vertices[corner]);
      }
      corner = place->second;
    }
    part.triangles.push_back(corners);
  }
  return part;
}

}  // namespace flashbvh::tool
