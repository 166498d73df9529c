#include "bake/build_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flashbvh::bake {
namespace {

std::array<std::int32_t, 3> extents(const Box& box) {
  return {box.upper.x - box.lower.x, box.upper.y - box.lower.y, box.upper.z - box.lower.z};
}

std::size_t longest_axis(const Box& box) {
  const auto extent = extents(box);
  return static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
}

std::int32_t coordinate(const Vertex& vertex, std::size_t axis) {
  return axis == 0 ? vertex.x : axis == 1 ? vertex.y : vertex.z;
}

/// Three times the centroid's coordinate.
std::int32_t centre(const LatticeMesh& mesh, std::uint32_t triangle, std::size_t axis) {
  std::int32_t sum = 0;
  for (const std::uint32_t corner : mesh.triangles[triangle]) {
    sum += coordinate(mesh.vertices[corner], axis);
  }
  return sum;
}

Box box_of_all(const LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Box box = box_of(mesh, triangles.front());
  for (const std::uint32_t triangle : triangles) {
    box = join(box, box_of(mesh, triangle));
  }
  return box;
}

/// Splits the node's triangles over two new children.
void split(BuildTree& tree, std::uint32_t node, const LatticeMesh& mesh) {
  std::vector<std::uint32_t> all = std::move(tree.nodes[node].triangles);
  tree.nodes[node].triangles.clear();
  const std::size_t axis = longest_axis(tree.nodes[node].box);
  std::sort(all.begin(), all.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::make_pair(centre(mesh, i, axis), i) < std::make_pair(centre(mesh, j, axis), j);
  });
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>((all.size() + 1) / 2);
  for (std::vector<std::uint32_t> half : {std::vector<std::uint32_t>(all.begin(), middle),
                                          std::vector<std::uint32_t>(middle, all.end())}) {
    tree.nodes[node].children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
    BuildNode child;
    child.box = box_of_all(mesh, half);
    child.triangles = std::move(half);
    tree.nodes.push_back(std::move(child));
  }
}

}  // namespace

Box join(const Box& a, const Box& b) {
  return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y),
           std::min(a.lower.z, b.lower.z)},
          {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y),
           std::max(a.upper.z, b.upper.z)}};
}

Box box_of(const LatticeMesh& mesh, std::uint32_t triangle) {
  const TriangleCorners& corners = mesh.triangles[triangle];
  Box box = {mesh.vertices[corners[0]], mesh.vertices[corners[0]]};
  for (const std::uint32_t corner : corners) {
    box = join(box, {mesh.vertices[corner], mesh.vertices[corner]});
  }
  return box;
}

BuildTree build_median(const LatticeMesh& mesh, std::uint32_t leaf_size) {
  BuildTree tree;
  BuildNode root;
  root.triangles.resize(mesh.triangles.size());
  std::iota(root.triangles.begin(), root.triangles.end(), 0u);
  root.box = box_of_all(mesh, root.triangles);
  tree.nodes.push_back(std::move(root));
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    if (tree.nodes[node].triangles.size() > leaf_size) {
      split(tree, node, mesh);
    }
  }
  return tree;
}

}  // namespace flashbvh::bake
