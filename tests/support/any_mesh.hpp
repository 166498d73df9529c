// Meshes in both layouts, poses, and queries in any traversal.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "support/queries.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"

namespace flashbvh::test {

/// A mesh in both layouts.
struct AnyMesh {
  std::tuple<Baked<Layout::pre_indexed>, Baked<Layout::post_indexed>> baked;

  AnyMesh(const bake::BuildTree& tree, const bake::LatticeMesh& mesh)
      : baked(bake::lay_out<std::uint16_t, Layout::pre_indexed>(tree, mesh),
              bake::lay_out<std::uint16_t, Layout::post_indexed>(tree, mesh)) {}

  template <class Tree>
  Tree view() const {
    return std::get<static_cast<std::size_t>(Tree::kLayout)>(baked).view();
  }
};

inline AnyMesh any_mesh(Random& random, const bake::LatticeMesh& mesh) {
  return AnyMesh(any_tree(random, mesh), mesh);
}

inline Pose any_pose(Random& random, std::int32_t reach) {
  const auto cells = [&] { return random.between(-reach, reach); };
  if (random.below(2) == 0) {
    return any_rigid_pose(random, reach);
  }
  const std::int32_t x = cells();
  const std::int32_t y = cells();
  return Pose::translated(x, y, cells());
}

/// Meshes with leaves of one triangle and of several, many of which intersect.
struct Scene {
  AnyMesh a, b;
  Pose pose;
};

inline Scene any_scene(Random& random) {
  const auto mesh = [&] {
    return any_mesh(random, random_mesh(random, 1 + random.below(16), 25, 25));
  };
  AnyMesh a = mesh();
  AnyMesh b = mesh();
  return {std::move(a), std::move(b), any_pose(random, 15)};
}

}  // namespace flashbvh::test
