// What ranks are made of.
#include <catch2/catch.hpp>

#include "bake/rank.hpp"
#include "flashbvh/mesh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using bake::BuildTree;

namespace {

constexpr Box kLargest = {{-kMaxCoordinate, -kMaxCoordinate, -kMaxCoordinate},
                          {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate}};
constexpr Box kPoint = {{5, 5, 5}, {5, 5, 5}};

/// A root over equal leaves.
BuildTree flat_tree(const Box& root, const Box& leaf, std::size_t count) {
  BuildTree tree;
  tree.nodes.push_back({root, {}, {}});
  for (std::size_t i = 0; i < count; ++i) {
    tree.nodes[0].children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
    tree.nodes.push_back({leaf, {}, {0}});
  }
  return tree;
}

std::uint32_t root_rank(const BuildTree& tree) {
  return bake::rank_of(tree, tree.nodes[0]);
}

}  // namespace

TEST_CASE("a box surely overlaps what its equal overlaps, and a point in it seldom") {
  CHECK(bake::chance_of_overlap(kLargest, kLargest) == bake::kSurely);
  CHECK(bake::chance_of_overlap(kPoint, kPoint) == bake::kSurely);
  CHECK(bake::chance_of_overlap(kLargest, kPoint) == bake::kSurely / 8);
}

TEST_CASE("ranks lie between 1 and the largest that a node can hold") {
  for (const std::size_t count : {1u, 2u, 8u, 1000u}) {
    for (const Box& leaf : {kPoint, kLargest}) {
      const std::uint32_t rank = root_rank(flat_tree(kLargest, leaf, count));
      CHECK(rank > 1);
      CHECK(rank <= static_cast<std::uint32_t>(kMaxRank));
    }
    CHECK(root_rank(flat_tree(kPoint, kPoint, count)) >= 1);
  }
}

TEST_CASE("a node ranks higher if it is larger, if its children are smaller, or fewer") {
  const Box large = {{0, 0, 0}, {800, 800, 800}};
  const Box half = {{0, 0, 0}, {800, 800, 400}};
  const Box quarter = {{0, 0, 0}, {800, 400, 400}};
  CHECK(root_rank(flat_tree(large, half, 2)) > root_rank(flat_tree(half, quarter, 2)));
  CHECK(root_rank(flat_tree(large, quarter, 2)) > root_rank(flat_tree(large, half, 2)));
  CHECK(root_rank(flat_tree(large, half, 2)) > root_rank(flat_tree(large, half, 8)));
}

TEST_CASE("the scale of ranks is monotone") {
  for (std::uint32_t measure = 1; measure < 3u << 16; ++measure) {
    REQUIRE(bake::rank_on_scale(measure - 1) <= bake::rank_on_scale(measure));
  }
  CHECK(bake::rank_on_scale((3u << 16) - 1) <= static_cast<std::uint32_t>(kMaxRank));
}
