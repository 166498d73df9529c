#include "support/shapes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "support/points.hpp"

namespace flashbvh::test {
namespace {

Vertex random_vertex(Random& random, const Vertex& centre, std::int32_t reach) {
  return {coordinate_near(random, centre.x, reach), coordinate_near(random, centre.y, reach),
          coordinate_near(random, centre.z, reach)};
}

std::vector<std::uint32_t> all_triangles(const bake::LatticeMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

bake::BuildTree single_leaf(const bake::LatticeMesh& mesh, std::vector<std::uint32_t> triangles) {
  bake::BuildTree tree;
  tree.nodes.push_back({box_of_all(mesh, triangles), {}, std::move(triangles)});
  return tree;
}

/// Gives the leaf `node` one child per part; the parts are its triangles.
void split(bake::BuildTree& tree, std::uint32_t node, const bake::LatticeMesh& mesh,
           const std::vector<std::vector<std::uint32_t>>& parts) {
  tree.nodes[node].triangles.clear();
  for (const auto& part : parts) {
    tree.nodes[node].children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
    tree.nodes.push_back({box_of_all(mesh, part), {}, part});
  }
}

/// Cuts a list into `count` parts, none of them empty.
std::vector<std::vector<std::uint32_t>> random_parts(Random& random,
                                                     std::vector<std::uint32_t> list,
                                                     std::uint32_t count) {
  std::vector<std::vector<std::uint32_t>> parts(count);
  for (std::uint32_t i = 0; i < list.size(); ++i) {
    parts[i < count ? i : random.below(count)].push_back(list[i]);
  }
  return parts;
}

}  // namespace

Box box_of_all(const bake::LatticeMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  Box box = bake::box_of(mesh, triangles.at(0));
  for (const std::uint32_t triangle : triangles) {
    box = bake::join(box, bake::box_of(mesh, triangle));
  }
  return box;
}

bake::LatticeMesh random_mesh(Random& random, std::uint32_t count, std::int32_t spread,
                              std::int32_t size) {
  bake::LatticeMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vertex centre = random_vertex(random, {0, 0, 0}, spread);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(random_vertex(random, centre, size));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

bake::BuildTree random_tree(Random& random, const bake::LatticeMesh& mesh, const Shape& shape) {
  bake::BuildTree tree = single_leaf(mesh, all_triangles(mesh));
  for (std::uint32_t node = 0; node < tree.nodes.size(); ++node) {
    const std::vector<std::uint32_t> triangles = tree.nodes[node].triangles;
    const auto count = static_cast<std::uint32_t>(triangles.size());
    if (shape.single_children && random.below(4) == 0 && tree.nodes.size() < 200) {
      split(tree, node, mesh, {triangles});
    } else if (count > shape.leaf_size || (count > 1 && random.below(2) == 0)) {
      const std::uint32_t parts = 2 + random.below(std::min(shape.arity, count) - 1);
      split(tree, node, mesh, random_parts(random, triangles, parts));
    }
  }
  return tree;
}

bake::BuildTree chain(const bake::LatticeMesh& mesh, bool leaf_first) {
  bake::BuildTree tree = single_leaf(mesh, all_triangles(mesh));
  std::uint32_t node = 0;
  while (tree.nodes[node].triangles.size() > 1) {
    std::vector<std::uint32_t> rest = tree.nodes[node].triangles;
    const std::vector<std::uint32_t> leaf = {rest.back()};
    rest.pop_back();
    if (leaf_first) {
      split(tree, node, mesh, {leaf, rest});
    } else {
      split(tree, node, mesh, {rest, leaf});
    }
    node = tree.nodes[node].children[leaf_first ? 1 : 0];
  }
  return tree;
}

bake::BuildTree any_tree(Random& random, const bake::LatticeMesh& mesh) {
  switch (random.below(8)) {
    case 0:
      return bake::build_median(mesh, 1 + random.below(3));
    case 1:
      return chain(mesh, random.below(2) == 0);
    case 2:
      return random_tree(random, mesh, {2, 1, false});
    case 3:
      return random_tree(random, mesh, {2 + random.below(7), 1, true});
    case 5:
      return bake::build_default(mesh, 1 + random.below(2));
    case 6: {
      const bake::BuildTree binary = bake::build_sah(mesh, 1 + random.below(4));
      return bake::collapse(binary, 2 + random.below(7));
    }
    case 4: {
      const bake::BuildTree binary = bake::build_median(mesh, 1 + random.below(4));
      return bake::collapse(binary, 2 + random.below(7));
    }
    default:
      return random_tree(random, mesh, {2 + random.below(3), 1 + random.below(16), true});
  }
}

}  // namespace flashbvh::test
