// Meshes in both layouts, poses, and queries in any traversal, also against brute force.
#pragma once

#include <cstdint>
#include <tuple>

#include "support/points.hpp"
#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"

namespace flashbvh::test {

/// A mesh in both layouts; it is a view of the post-indexed one.
struct AnyMesh : Mesh {
  bake::LatticeMesh source;
  std::tuple<Baked<Layout::pre_indexed>, Baked<Layout::post_indexed>> trees;

  AnyMesh(const bake::BuildTree& tree, const bake::LatticeMesh& mesh)
      : source(mesh),
        trees(baked<Layout::pre_indexed>(tree, mesh), baked<Layout::post_indexed>(tree, mesh)) {
    static_cast<Mesh&>(*this) = view<Mesh>();
  }
  AnyMesh(AnyMesh&&) = default;  // the arrays stay where they are

  template <class Tree>
  Tree view() const {
    return std::get<static_cast<std::size_t>(Tree::kLayout)>(trees).view();
  }
};

/// Half of them have no slabs, as meshes that bend.
inline AnyMesh any_mesh(Random& random, const bake::LatticeMesh& mesh) {
  AnyMesh any(any_tree(random, mesh), mesh);
  if (random.below(2) == 0) {
    std::get<1>(any.trees).slabs.clear();
    any.slabs = nullptr;
  }
  return any;
}

/// Of up to `most` triangles, as random_mesh() makes them.
inline AnyMesh any_mesh(Random& random, std::uint32_t most, std::int32_t spread,
                        std::int32_t size) {
  return any_mesh(random, random_mesh(random, 1 + random.below(most), spread, size));
}

/// Checks every traversal against brute force. `a` and `b` may be one mesh. Returns the number of
/// pairs.
inline std::size_t check_all(const AnyMesh& a, const AnyMesh& b, const Pose& pose) {
  const Pairs truth = brute_force(a.source, b.source, pose);
  check_pairs(a.view<MeshWithLevels>(), b.view<MeshWithLevels>(), pose, truth);
  check_pairs(a.view<PreMeshWithLevels>(), b.view<PreMeshWithLevels>(), pose, truth);
  return truth.size();
}

inline Pose any_pose(Random& random, std::int32_t reach) {
  if (random.below(2) == 0) {
    return any_rigid_pose(random, reach);
  }
  const Point by = any_point(random, reach);
  return Pose::translated(by.x, by.y, by.z);
}

struct Scene {
  AnyMesh a, b;
  Pose pose;
};

/// Meshes with leaves of one triangle and of several, many of which intersect.
inline Scene any_scene(Random& random) {
  return {any_mesh(random, 16, 25, 25), any_mesh(random, 16, 25, 25), any_pose(random, 15)};
}

}  // namespace flashbvh::test
