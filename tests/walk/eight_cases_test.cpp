// The eight cases of sections 6.3 and 7.1, one by one, on the full tree of 15 nodes of figure 1:
//
//                      0
//            1                   8            level 1
//        2       5           9       12       level 2
//      3   4   6   7       10 11   13  14     level 3
//
// and the extensions of section 8.1.
#include <catch2/catch.hpp>

#include "support/record.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

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
  using Traversal = AlternatingStackless<BasicMeshWithLevels<std::uint16_t, layout>>;
  Traversal order(
      tree, tree,
      {static_cast<std::uint16_t>(to_layout(a)), static_cast<std::uint16_t>(to_layout(b))});
  const bool goes_on = order.next();
  CHECK(goes_on == (order.index_a() != kEnd && order.index_b() != kEnd));
  return {to_number(order.index_a()), to_number(order.index_b())};
}

void check_next(std::uint32_t a, std::uint32_t b, NodePair expected) {
  CAPTURE(a, b);
  CHECK(test_next<Layout::pre_indexed>(a, b) == expected);
  CHECK(test_next<Layout::post_indexed>(a, b) == expected);
}

}  // namespace

TEST_CASE("case 1: same level, both left: A escapes") {
  check_next(1, 1, {8, 1});
  check_next(2, 9, {5, 9});
  check_next(3, 13, {4, 13});
}

TEST_CASE("case 2: same level, A left, B right: A escapes") {
  check_next(1, 8, {8, 8});
  check_next(2, 5, {5, 5});
  check_next(10, 14, {11, 14});
}

TEST_CASE("case 3: A a level above B, both left: B escapes") {
  check_next(1, 2, {1, 5});
  check_next(2, 13, {2, 14});
}

TEST_CASE("case 4: A a level above B, A right, B left: B escapes") {
  check_next(8, 2, {8, 5});
  check_next(5, 3, {5, 4});
  check_next(0, 1, {0, 8});
}

TEST_CASE("case 5: same level, A right, B left: A to its parent, B escapes") {
  check_next(8, 1, {0, 8});
  check_next(5, 2, {1, 5});
  check_next(14, 6, {12, 7});
}

TEST_CASE("case 6: A a level above B, A left, B right: A escapes, B to its parent") {
  check_next(1, 5, {8, 1});
  check_next(2, 7, {5, 5});
}

TEST_CASE("case 7: same level, both right: up along right children to a left one") {
  // A's left child is reached first, or both at once.
  check_next(5, 5, {8, 1});   // RCL 1 and 1
  check_next(5, 12, {8, 8});  // 1 and 2
  check_next(4, 14, {5, 12});
  check_next(7, 14, {8, 8});  // 2 and 3
  // B's left child is reached first.
  check_next(12, 5, {0, 8});  // 2 and 1
  check_next(14, 4, {8, 5});  // 3 and 1
  check_next(14, 11, {8, 12});
  check_next(14, 7, {0, 8});  // 3 and 2
  // Neither: the walk is over.
  check_next(8, 8, {kEnd, 0});
}

TEST_CASE("case 8: A a level above B, both right: as case 7 with B's parent") {
  // A's left child is reached first, or both at once.
  check_next(5, 7, {8, 1});   // RCL 1 and 2
  check_next(5, 14, {8, 8});  // 1 and 3
  // B's left child is reached first.
  check_next(8, 5, {0, 8});   // 1 and 1
  check_next(12, 7, {0, 8});  // 2 and 2
  check_next(12, 4, {8, 5});  // 2 and 1
}

TEST_CASE("section 8.1: levels further apart go up to where the leaf was reached") {
  // B is a leaf, A below its level: the leaf algorithm in A's subtree.
  check_next(3, 1, {4, 1});  // as if node 1 of B were a leaf
  check_next(4, 1, {5, 1});
  check_next(7, 1, {8, 1});   // the subtree of A's node 1 is done
  check_next(14, 1, {0, 8});  // A's node 8 is done: case 5
  check_next(14, 8, {kEnd, 0});
  // A is a leaf, B below its level: the leaf algorithm in B's subtree.
  check_next(1, 3, {1, 4});
  check_next(1, 4, {1, 5});
  check_next(1, 7, {8, 1});  // the subtree of B's node 1 is done: case 1
  check_next(8, 7, {0, 8});  // case 5
  check_next(8, 14, {kEnd, 0});
}
