// Deformable meshes for tests: soups, sheets and tubes, and ways to move their vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/deformable.hpp"
#include "support/points.hpp"
#include "support/shapes.hpp"

namespace flashbvh::test {

/// A grid of 2 * columns * rows triangles; `round`: its first column follows the last one.
inline bake::LatticeMesh grid(std::uint32_t columns, std::uint32_t rows, bool round) {
  bake::LatticeMesh mesh;
  const std::uint32_t width = round ? columns : columns + 1;
  mesh.vertices.resize(std::size_t{width} * (rows + 1));
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * width + i % width; };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Lays out the vertices of a grid in rows of `width`, `pitch` cells apart, in folds 2 * `fold`
/// cells high, and moves each by up to `noise`.
inline void lay(Random& random, std::uint32_t width, std::int32_t pitch, std::int32_t fold,
                std::int32_t noise, std::vector<Vertex>& vertices) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto i = static_cast<std::int32_t>(v % width);
    const auto j = static_cast<std::int32_t>(v / width);
    const std::int32_t up = i % 4 < 2 ? i % 4 : 4 - i % 4;
    vertices[v] = {coordinate_near(random, i * pitch, noise),
                   coordinate_near(random, j * pitch, noise),
                   coordinate_near(random, up * fold, noise)};
  }
}

/// Moves a random subset of the vertices by up to `by`, or all of it into one point or plane.
inline void move_some(Random& random, std::int32_t by, std::vector<Vertex>& vertices) {
  const std::uint32_t one_in = 1 + random.below(4);
  const std::uint32_t kind = random.below(16);
  for (Vertex& at : vertices) {
    if (random.below(one_in) == 0) {
      at = {coordinate_near(random, at.x, by), coordinate_near(random, at.y, by),
            kind == 0 ? std::int16_t{0} : coordinate_near(random, at.z, by)};
      at = kind == 1 ? vertices[0] : at;
    }
  }
}

/// A soup, a sheet or a tube of at most some 40 triangles, laid out at random.
inline bake::LatticeMesh any_bendable(Random& random) {
  const std::uint32_t kind = random.below(3);
  if (kind == 0) {
    return random_mesh(random, 1 + random.below(24), 40, 25);
  }
  const std::uint32_t columns = 3 + random.below(3);
  bake::LatticeMesh mesh = grid(columns, 1 + random.below(4), kind == 1);
  const std::uint32_t width = 3 + random.below(3);
  const auto noise = static_cast<std::int32_t>(random.below(12));
  lay(random, width, 10, 5, noise, mesh.vertices);
  return mesh;
}

/// A deformable mesh, of any baked tree, and its memory.
template <class MeshType>
struct Bending {
  using Index = typename MeshType::Index;
  bake::LatticeMesh lattice;
  bake::BakedTree<Index, MeshType::kLayout> baked;
  std::vector<Node<Index>> nodes;
  std::vector<Vertex> vertices;
  BasicDeformableMesh<MeshType> mesh;

  Bending(const bake::BuildTree& tree, const bake::LatticeMesh& from, bool shows_quads = true)
      : lattice(from),
        baked(bake::lay_out<Index, MeshType::kLayout>(tree, lattice)),
        nodes(baked.nodes.size()),
        vertices(baked.vertices.size()),
        mesh(shown(baked, shows_quads).view(), nodes.data(), vertices.data()) {}
  static const auto& shown(decltype(baked)& tree, bool shows_quads) {
    if (shows_quads) {
      bake::show_quads(tree);
    }
    return tree;
  }
  Bending(const Bending&) = delete;
  Bending& operator=(const Bending&) = delete;

  /// The source mesh with the current vertices.
  bake::LatticeMesh now() const {
    bake::LatticeMesh mesh_now = lattice;
    mesh_now.vertices = vertices;
    return mesh_now;
  }
};

}  // namespace flashbvh::test
