// The paper's definitions on baked trees of every form, and its figures.
#include "flashbvh/traversal/levels.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

namespace {

/// Checks every definition node by node, by the BuildTree's parents and children.
template <Layout layout>
void check_definitions(const bake::BuildTree& build, const Baked<layout>& baked) {
  const auto tree = baked.view();
  std::vector<std::uint32_t> position(build.nodes.size());  // of each node in the array
  for (std::uint32_t i = 0; i < position.size(); ++i) {
    position[baked.build_nodes[i]] = i;
  }
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

// Figure 1's tree, pre-indexed:
//
//                      0
//            1                   8            level 1
//        2       5           9       12       level 2
//      3   4   6   7       10 11   13  14     level 3
constexpr std::uint32_t kEnd = 15;

/// The values of a function of the nodes, in the order of the array.
template <class Function>
std::vector<std::uint32_t> values(Function function) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t node = 0; node < kEnd; ++node) {
    found.push_back(function(node));
  }
  return found;
}

}  // namespace

TEST_CASE("figures 1, 3, 22 and 26: levels, right child levels and escape indices") {
  using List = std::vector<std::uint32_t>;
  Random random(1);
  const auto mesh = random_mesh(random, 8, 100, 10);
  const auto build = bake::build_median(mesh, 1);
  const auto of_pre = baked<Layout::pre_indexed>(build, mesh);
  const auto pre = of_pre.view();
  const auto of_post = baked(build, mesh);
  const auto post = of_post.view();
  REQUIRE((pre.node_count == kEnd && post.node_count == kEnd));
  CHECK(values([&](std::uint32_t node) { return pre.escape(node); }) ==
        List{15, 8, 5, 4, 5, 8, 7, 8, 15, 12, 11, 12, 15, 14, 15});
  CHECK(values([&](std::uint32_t node) { return pre.level(node); }) ==
        List{0, 1, 2, 3, 3, 2, 3, 3, 1, 2, 3, 3, 2, 3, 3});
  CHECK(values([&](std::uint32_t node) { return pre.rcl(node); }) ==
        List{0, 0, 0, 0, 1, 1, 0, 2, 1, 0, 0, 1, 2, 0, 3});
  CHECK(values([&](std::uint32_t node) { return post.rcl(node); }) ==
        List{0, 1, 2, 3, 0, 0, 1, 0, 0, 1, 2, 0, 0, 1, 0});
  CHECK(values([&](std::uint32_t node) { return post.escape(node); }) ==
        List{15, 15, 15, 15, 3, 2, 2, 6, 1, 1, 1, 10, 9, 9, 13});
}

TEST_CASE("the definitions hold on random trees of every shape") {
  for_rounds(300, [&](Random& random, int) {
    const auto mesh = random_mesh(random, 1 + random.below(24), 100, 20);
    const auto build = any_tree(random, mesh);
    check_definitions(build, baked<Layout::pre_indexed>(build, mesh));
    check_definitions(build, baked(build, mesh));
  });
}
