// The paper's definitions on baked trees of every shape. Those of its figures:
// definitions_board_test.cpp.
#include <catch2/catch.hpp>

#include "bake/baked_tree.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr Layout kPre = Layout::pre_indexed;
constexpr Layout kPost = Layout::post_indexed;

template <Layout layout>
using Baked = bake::BakedTree<std::uint16_t, layout>;

/// A mesh of `count` triangles; the definitions do not depend on where they lie.
bake::LatticeMesh any_mesh(std::uint32_t count) {
  Random random(1);
  return random_mesh(random, count, 100, 10);
}

/// Array position of each node of the BuildTree.
template <Layout layout>
std::vector<std::uint32_t> positions(const Baked<layout>& baked) {
  std::vector<std::uint32_t> position(baked.build_nodes.size());
  for (std::uint32_t i = 0; i < position.size(); ++i) {
    position[baked.build_nodes[i]] = i;
  }
  return position;
}

/// Checks every definition node by node, by the BuildTree's parents and children.
template <Layout layout>
void check_definitions(const bake::BuildTree& build, const Baked<layout>& baked) {
  const auto tree = baked.view();
  const auto position = positions(baked);
  REQUIRE(tree.escape(0) == tree.node_count);  // definition 3.3
  REQUIRE(tree.level(0) == 0);
  REQUIRE(tree.rcl(0) == 0);
  for (std::uint32_t i = 0; i < build.nodes.size(); ++i) {
    const std::uint32_t parent = position[i];
    const auto& children = build.nodes[i].children;
    REQUIRE(tree.nodes[parent].is_leaf() == children.empty());
    if (children.empty()) {
      continue;
    }
    REQUIRE(tree.first_child(parent) == position[children.front()]);
    for (std::size_t k = 0; k < children.size(); ++k) {
      const std::uint32_t child = position[children[k]];
      const bool last = k + 1 == children.size();
      REQUIRE(tree.level(child) == tree.level(parent) + 1);
      REQUIRE(tree.is_last_child(parent, child) == last);
      if (last) {
        REQUIRE(tree.escape(child) == tree.escape(parent));  // definition 3.2
        REQUIRE(tree.rcl(child) == tree.rcl(parent) + 1);
        REQUIRE(tree.level_up(child, 1) == parent);
        REQUIRE(tree.level_up(child, tree.rcl(child)) == tree.level_up(parent, tree.rcl(parent)));
      } else {
        REQUIRE(tree.escape(child) == position[children[k + 1]]);  // definitions 3.1, 8.1
        REQUIRE(tree.next_sibling(child) == position[children[k + 1]]);
        REQUIRE(tree.rcl(child) == 0);
      }
    }
  }
}

void check_both_layouts(const bake::BuildTree& build, const bake::LatticeMesh& mesh) {
  check_definitions(build, bake::lay_out<std::uint16_t, kPre>(build, mesh));
  check_definitions(build, bake::lay_out<std::uint16_t, kPost>(build, mesh));
}

}  // namespace

TEST_CASE("section 8.2: a single child is a last child") {
  bake::BuildTree build;
  const auto mesh = any_mesh(1);
  const Box box = bake::box_of(mesh, 0);
  build.nodes.push_back({box, {1}, {}});
  build.nodes.push_back({box, {2}, {}});
  build.nodes.push_back({box, {}, {0}});
  check_both_layouts(build, mesh);
}

TEST_CASE("figure 24: all but the last of many children are left children") {
  const auto mesh = any_mesh(6);
  bake::BuildTree build;
  build.nodes.push_back({bake::box_of(mesh, 0), {1, 2, 3, 4, 5, 6}, {}});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const Box box = bake::box_of(mesh, i);
    build.nodes[0].box = bake::join(build.nodes[0].box, box);
    build.nodes.push_back({box, {}, {i}});
  }
  check_both_layouts(build, mesh);
}

TEST_CASE("the definitions hold on random trees of every shape") {
  Random random = test_random();
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const auto mesh = random_mesh(random, 1 + random.below(24), 100, 20);
    check_both_layouts(any_tree(random, mesh), mesh);
  }
}

TEST_CASE("chains as deep as their triangles keep the definitions") {
  const auto mesh = any_mesh(300);
  check_both_layouts(chain(mesh, true), mesh);
  check_both_layouts(chain(mesh, false), mesh);
}
