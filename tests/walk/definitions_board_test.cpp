// The paper's definitions on the tree of figure 1, on every board: the full binary tree of depth 3.
#include <catch2/catch.hpp>

#include "digest/small_mesh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr uint32_t kNodes = 15;

template <Layout layout>
struct FullTree {
  digest::SmallMesh mesh;
  digest::SmallTree<layout> tree;

  FullTree() {
    Random random(1);
    do {
      digest::make_mesh(random, digest::kScales[1], mesh);
    } while (mesh.triangle_count < 8);
    mesh.triangle_count = 8;
    tree.make(mesh, digest::Shape::halves, 1);
  }
};

/// Whether a function of the nodes has these values.
template <class Function>
bool has_values(const uint16_t (&expected)[kNodes], Function function) {
  for (uint32_t node = 0; node < kNodes; ++node) {
    if (function(node) != expected[node]) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("small trees: escape indices and levels of the paper's figures 1 and 3, pre-indexed") {
  const FullTree<Layout::pre_indexed> full;
  const PreMeshWithLevels& tree = full.tree.view();
  REQUIRE(tree.node_count == kNodes);
  CHECK(has_values({15, 8, 5, 4, 5, 8, 7, 8, 15, 12, 11, 12, 15, 14, 15},
                   [&tree](uint32_t node) { return tree.escape(node); }));
  CHECK(has_values({0, 1, 2, 3, 3, 2, 3, 3, 1, 2, 3, 3, 2, 3, 3},
                   [&tree](uint32_t node) { return tree.level(node); }));
}

TEST_CASE("small trees: right child levels of the paper's figure 22") {
  const FullTree<Layout::pre_indexed> pre;
  CHECK(has_values({0, 0, 0, 0, 1, 1, 0, 2, 1, 0, 0, 1, 2, 0, 3},
                   [&pre](uint32_t node) { return pre.tree.view().rcl(node); }));
  const FullTree<Layout::post_indexed> post;
  CHECK(has_values({0, 1, 2, 3, 0, 0, 1, 0, 0, 1, 2, 0, 0, 1, 0},
                   [&post](uint32_t node) { return post.tree.view().rcl(node); }));
}

TEST_CASE("small trees: post-indexed, LevelUp subtracts, and escape indices of figure 26") {
  const FullTree<Layout::post_indexed> full;
  const MeshWithLevels& tree = full.tree.view();
  CHECK(tree.level_up(3, 3) == 0);
  CHECK(tree.level_up(3, 2) == 1);
  CHECK(tree.level_up(2, 1) == 1);
  CHECK(has_values({15, 15, 15, 15, 3, 2, 2, 6, 1, 1, 1, 10, 9, 9, 13},
                   [&tree](uint32_t node) { return tree.escape(node); }));
}
