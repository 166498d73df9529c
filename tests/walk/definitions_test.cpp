// The paper's definitions on baked trees of every form, and its figures.
#include "support/record.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

namespace {

/// A mesh of `count` triangles; the definitions do not depend on their coordinates.
bake::LatticeMesh any_mesh(std::uint32_t count) {
  Random random(1);
  return random_mesh(random, count, 100, 10);
}

/// The array index of each node of the BuildTree.
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
  check_definitions(build, baked<Layout::pre_indexed>(build, mesh));
  check_definitions(build, baked<Layout::post_indexed>(build, mesh));
}

// The eight cases of sections 6.3 and 7.1, and the extensions of section 8.1, on figure 1's tree:
//
//                      0
//            1                   8            level 1
//        2       5           9       12       level 2
//      3   4   6   7       10 11   13  14     level 3
constexpr std::uint32_t kEnd = 15;

/// The pair after (a, b), by pre-indexed numbers in both layouts.
template <Layout layout>
NodePair test_next(std::uint32_t a, std::uint32_t b) {
  static Random random(1);
  static const auto mesh = random_mesh(random, 8, 100, 10);
  static const auto numbers =
      bake::lay_out<std::uint16_t, Layout::pre_indexed>(full_tree(mesh, 3), mesh);
  static const auto baked = bake::lay_out<std::uint16_t, layout>(full_tree(mesh, 3), mesh);
  const auto position = [](const auto& tree, std::uint32_t build_node) {
    std::uint32_t i = 0;
    while (tree.build_nodes[i] != build_node) {
      ++i;
    }
    return i;
  };
  const auto to_layout = [&](std::uint32_t i) { return position(baked, numbers.build_nodes[i]); };
  const auto to_number = [&](std::uint32_t i) {
    return i == kEnd ? kEnd : position(numbers, baked.build_nodes[i]);
  };
  const auto tree = baked.view();
  using Traversal = BasicStackless<BasicMeshWithLevels<std::uint16_t, layout>>;
  Traversal order(
      tree, tree,
      {static_cast<std::uint16_t>(to_layout(a)), static_cast<std::uint16_t>(to_layout(b))});
  const bool goes_on = order.next();
  CHECK(goes_on == (order.index_a() != kEnd && order.index_b() != kEnd));
  return {to_number(order.index_a()), to_number(order.index_b())};
}

template <Layout layout>
Baked<layout> figure_1() {
  const auto mesh = any_mesh(8);
  return baked<layout>(full_tree(mesh, 3), mesh);
}

/// The values of a function of the nodes, in the order of the array.
template <class Function>
std::vector<std::uint32_t> values(Function function) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t node = 0; node < kEnd; ++node) {
    found.push_back(function(node));
  }
  return found;
}

struct Step {
  std::uint32_t a, b;
  NodePair next;
};

const Step kSteps[] = {
    // Case 1: same level, both left: A escapes.
    {1, 1, {8, 1}},
    {2, 9, {5, 9}},
    {3, 13, {4, 13}},
    // Case 2: same level, A left, B right: A escapes.
    {1, 8, {8, 8}},
    {2, 5, {5, 5}},
    {10, 14, {11, 14}},
    // Case 3: A a level above B, both left: B escapes.
    {1, 2, {1, 5}},
    {2, 13, {2, 14}},
    // Case 4: A a level above B, A right, B left: B escapes.
    {8, 2, {8, 5}},
    {5, 3, {5, 4}},
    {0, 1, {0, 8}},
    // Case 5: same level, A right, B left: A to its parent, B escapes.
    {8, 1, {0, 8}},
    {5, 2, {1, 5}},
    {14, 6, {12, 7}},
    // Case 6: A a level above B, A left, B right: A escapes, B to its parent.
    {1, 5, {8, 1}},
    {2, 7, {5, 5}},
    // Case 7: same level, both right: up along right children to a left one.
    // A's left child is reached first, or both at once.
    {5, 5, {8, 1}},   // RCL 1 and 1
    {5, 12, {8, 8}},  // 1 and 2
    {4, 14, {5, 12}},
    {7, 14, {8, 8}},  // 2 and 3
    // B's left child is reached first.
    {12, 5, {0, 8}},  // 2 and 1
    {14, 4, {8, 5}},  // 3 and 1
    {14, 11, {8, 12}},
    {14, 7, {0, 8}},  // 3 and 2
    // Neither: the walk is over.
    {8, 8, {kEnd, 0}},
    // Case 8: A a level above B, both right: as case 7 with B's parent.
    // A's left child is reached first, or both at once.
    {5, 7, {8, 1}},   // RCL 1 and 2
    {5, 14, {8, 8}},  // 1 and 3
    // B's left child is reached first.
    {8, 5, {0, 8}},   // 1 and 1
    {12, 7, {0, 8}},  // 2 and 2
    {12, 4, {8, 5}},  // 2 and 1
    // Section 8.1: levels further apart go up to where the leaf was reached.
    // B is a leaf, A below its level: the leaf algorithm in A's subtree.
    {3, 1, {4, 1}},  // as if node 1 of B were a leaf
    {4, 1, {5, 1}},
    {7, 1, {8, 1}},   // the subtree of A's node 1 is done
    {14, 1, {0, 8}},  // A's node 8 is done: case 5
    {14, 8, {kEnd, 0}},
    // A is a leaf, B below its level: the leaf algorithm in B's subtree.
    {1, 3, {1, 4}},
    {1, 4, {1, 5}},
    {1, 7, {8, 1}},  // the subtree of B's node 1 is done: case 1
    {8, 7, {0, 8}},  // case 5
    {8, 14, {kEnd, 0}},
};

}  // namespace

TEST_CASE("figures 1, 3, 22 and 26: levels, right child levels and escape indices") {
  using List = std::vector<std::uint32_t>;
  const auto of_pre = figure_1<Layout::pre_indexed>();
  const auto pre = of_pre.view();
  const auto of_post = figure_1<Layout::post_indexed>();
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
  check_both_layouts(star(mesh), mesh);
}

TEST_CASE("the definitions hold on random trees of every shape") {
  for_rounds(300, [&](Random& random, int) {
    const auto mesh = random_mesh(random, 1 + random.below(24), 100, 20);
    check_both_layouts(any_tree(random, mesh), mesh);
  });
}

TEST_CASE("chains as deep as their triangles keep the definitions") {
  const auto mesh = any_mesh(300);
  check_both_layouts(chain(mesh, true), mesh);
  check_both_layouts(chain(mesh, false), mesh);
}

TEST_CASE("each case of the walk without a stack, in both layouts") {
  for (const Step& step : kSteps) {
    CAPTURE(step.a, step.b);
    CHECK(test_next<Layout::pre_indexed>(step.a, step.b) == step.next);
    CHECK(test_next<Layout::post_indexed>(step.a, step.b) == step.next);
  }
}
