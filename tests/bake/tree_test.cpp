// Trees: those of the surface area heuristic are complete, with tight boxes, for any input; and the
// origin of ranks.
#include <optional>
#include <set>

#include "bake/binary_tree.hpp"
#include "bake/image_bytes.hpp"
#include "bake/measure.hpp"
#include "bake/rank.hpp"
#include "flashbvh/mesh.hpp"
#include "support/points.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

using namespace flashbvh::detail;
using bake::BuildNode;
using bake::BuildTree;
using bake::LatticeMesh;

namespace {

/// Checks that every node but the root is a child once, every triangle is in one leaf, and boxes
/// are tight.
void check_whole(const BuildTree& tree, const LatticeMesh& mesh, std::uint32_t leaf_size,
                 std::uint32_t arity) {
  std::vector<std::uint32_t> parents(tree.nodes.size(), 0);
  std::vector<std::uint32_t> leaves(mesh.triangles.size(), 0);
  bool tight = true;
  for (const BuildNode& node : tree.nodes) {
    for (const std::uint32_t triangle : node.triangles) {
      ++leaves.at(triangle);
    }
    if (node.is_leaf()) {
      REQUIRE_FALSE(node.triangles.empty());
      REQUIRE(node.triangles.size() <= leaf_size);
      tight = tight && same(node.box, box_of_all(mesh, node.triangles));
      continue;
    }
    REQUIRE(node.triangles.empty());
    REQUIRE(node.children.size() >= 2);
    REQUIRE(node.children.size() <= arity);
    Box box = tree.nodes.at(node.children[0]).box;
    for (const std::uint32_t child : node.children) {
      ++parents.at(child);
      box = bake::join(box, tree.nodes.at(child).box);
    }
    tight = tight && same(node.box, box);
  }
  CHECK(tight);
  CHECK(parents[0] == 0);
  CHECK(std::count(parents.begin() + 1, parents.end(), 1u) ==
        static_cast<std::ptrdiff_t>(parents.size()) - 1);
  CHECK(std::count(leaves.begin(), leaves.end(), 1u) == static_cast<std::ptrdiff_t>(leaves.size()));
}

using flashbvh::test::same;

bool same(const BuildTree& p, const BuildTree& q) {
  return std::equal(p.nodes.begin(), p.nodes.end(), q.nodes.begin(), q.nodes.end(),
                    [](const BuildNode& a, const BuildNode& b) {
                      return same(a.box, b.box) && a.children == b.children &&
                             a.triangles == b.triangles;
                    });
}

std::uint32_t depth_of(const BuildTree& tree) {
  std::vector<std::uint32_t> depths(tree.nodes.size(), 0);
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
    for (const std::uint32_t child : tree.nodes[node].children) {
      depths[child] = depths[node] + 1;
    }
  }
  return *std::max_element(depths.begin(), depths.end());
}

/// `count` copies of a triangle with the given corners.
LatticeMesh repeated(std::uint32_t count, const Vertex& p, const Vertex& q, const Vertex& r) {
  LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles.assign(count, {0, 1, 2});
  return mesh;
}

/// A chain of segments along an axis.
LatticeMesh row(std::uint32_t count, int axis) {
  LatticeMesh mesh;
  for (std::uint32_t i = 0; i <= count; ++i) {
    const auto at = static_cast<std::int16_t>(i * 7);
    mesh.vertices.push_back(axis == 0   ? Vertex{at, 0, 0}
                            : axis == 1 ? Vertex{0, at, 0}
                                        : Vertex{0, 0, at});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.triangles.push_back({i, i + 1, i});
  }
  return mesh;
}

/// Triangles around one point, each larger by `percent` than the previous one, as far as they fit.
LatticeMesh nested(std::int32_t percent) {
  LatticeMesh mesh;
  for (std::int32_t size = 1; size <= kMaxCoordinate;
       size += std::max<std::int32_t>(1, size * percent / 100)) {
    const auto reach = static_cast<std::int16_t>(size);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto low = static_cast<std::int16_t>(-reach);
    mesh.vertices.push_back({low, low, low});
    mesh.vertices.push_back({reach, reach, reach});
    mesh.triangles.push_back({first, first + 1, first});
  }
  return mesh;
}

std::multiset<std::uint64_t> surfaces(const BuildTree& tree) {
  std::multiset<std::uint64_t> all;
  for (const BuildNode& node : tree.nodes) {
    all.insert(bake::half_surface(node.box));
  }
  return all;
}

/// The sum of the surfaces of all internal nodes.
template <class Tree>
std::uint64_t cost_of(const Tree& tree) {
  std::uint64_t sum = 0;
  for (const auto& node : tree.nodes) {
    sum += node.is_leaf() ? 0 : bake::half_surface(node.box);
  }
  return sum;
}

constexpr Box kLargest = {{-kMaxCoordinate, -kMaxCoordinate, -kMaxCoordinate},
                          {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate}};
constexpr Box kPoint = {{5, 5, 5}, {5, 5, 5}};

/// A root over leaves with equal boxes.
BuildTree flat_tree(const Box& root, const Box& leaf, std::size_t count) {
  BuildTree tree;
  tree.nodes.push_back({root, {}, {}});
  for (std::size_t i = 0; i < count; ++i) {
    tree.nodes[0].children.push_back(static_cast<std::uint32_t>(tree.nodes.size()));
    tree.nodes.push_back({leaf, {}, {0}});
  }
  return tree;
}

}  // namespace

TEST_CASE("surface area heuristic: whole trees with tight boxes, all leaf sizes and arities") {
  for_rounds(150, [&](Random& random, int round) {
    const std::int32_t spread = round % 3 == 0 ? 3 : 300;
    const LatticeMesh mesh = random_mesh(random, 1 + random.below(120), spread, 30);
    const std::uint32_t leaf_size = 1 + random.below(16);
    const std::uint32_t arity = 2 + random.below(7);
    CAPTURE(round, leaf_size, arity, mesh.triangles.size());
    const BuildTree tree = bake::build_sah(mesh, leaf_size);
    check_whole(tree, mesh, leaf_size, 2);
    check_whole(bake::collapse(tree, arity), mesh, leaf_size, arity);
    CHECK(same(bake::collapse(tree, 2), bake::collapse(bake::collapse(tree, 2), 2)));
  });
}

TEST_CASE("surface area heuristic: equal triangles and rows are halved, nested ones become deep") {
  const Vertex zero = {0, 0, 0};
  const std::pair<LatticeMesh, std::optional<std::uint32_t>> meshes[] = {
      {repeated(1, zero, {5, 1, 0}, {0, 5, 9}), 0},
      {repeated(2, zero, {5, 1, 0}, {0, 5, 9}), 1},
      {repeated(1024, zero, zero, zero), 10},
      {repeated(1024, zero, zero, {9, 0, 0}), 10},
      {repeated(1024, zero, zero, {9, 9, 0}), 10},
      {repeated(1024, zero, zero, {9, 8, 7}), 10},
      {row(1024, 0), 10},
      {row(1024, 1), 10},
      {row(1024, 2), 10},
      {nested(100), std::nullopt},
      {nested(30), std::nullopt},
      {nested(1), std::nullopt}};
  for (const auto& [mesh, depth] : meshes) {
    const BuildTree tree = bake::build_sah(mesh, 1);
    CAPTURE(mesh.triangles.size(), depth_of(tree));
    check_whole(tree, mesh, 1, 2);
    check_whole(bake::build_default(mesh), mesh, bake::kMostByMesh, 4);
    CHECK(depth_of(tree) == depth.value_or(depth_of(tree)));
  }
}

TEST_CASE("reinsertion never makes a tree cost more, and keeps it whole") {
  int improved = 0;
  for_rounds(60, 1, [&](Random& random, int) {
    const LatticeMesh mesh = random_mesh(random, 1 + random.below(200), 200, 60);
    bake::BinaryTree tree = bake::sweep(mesh);
    const std::uint64_t before = cost_of(tree);
    bake::reinsert_all(tree);
    const std::uint64_t after = cost_of(tree);
    CHECK(after <= before);
    for (const bake::BinaryNode& node : tree.nodes) {
      REQUIRE(node.surface == bake::half_surface(node.box));
    }
    check_whole(bake::with_leaves(tree, bake::largest_leaves(tree, 1)), mesh, 1, 2);
    improved += after < before ? 1 : 0;
  });
  CHECK(improved > 30);
}

TEST_CASE("by default a triangle takes at most 27 bytes, and leaves up to four") {
  for (const LatticeMesh& mesh : {torus(24, 12, 3000, 900), torus(60, 30, 9000, 4000)}) {
    const auto baked = test::baked<Layout::post_indexed>(bake::build_default(mesh), mesh);
    CHECK(bake::image_size(baked) <= bake::kBytesByMesh * mesh.triangles.size());
    CHECK(baked.leaf_size == bake::kMostByMesh);
  }
}

TEST_CASE("surface area heuristic: it costs less than the median, and builds the same again") {
  const LatticeMesh mesh = torus(24, 12, 3000, 900);
  CHECK(same(bake::build_default(mesh), bake::build_default(mesh)));
  CHECK(cost_of(bake::build_sah(mesh, 1)) < cost_of(bake::build_median(mesh, 1)));
}

TEST_CASE("surface area heuristic: the order of the triangles decides only between equals") {
  for_rounds(20, 2, [&](Random& random, int) {
    // Far apart and irregular: no two centres or costs are equal.
    LatticeMesh mesh = random_mesh(random, 60, 16000, 350);
    const auto all = [&] {
      const bake::BinaryTree tree = bake::sweep(mesh);
      return surfaces(bake::with_leaves(tree, bake::largest_leaves(tree, 1)));
    };
    const auto before = all();
    for (std::size_t i = mesh.triangles.size() - 1; i > 0; --i) {
      std::swap(mesh.triangles[i], mesh.triangles[random.below(static_cast<std::uint32_t>(i) + 1)]);
    }
    CHECK(all() == before);
  });
}

TEST_CASE("ranks lie between 1 and the largest that a node can hold") {
  for (const Box& root : {kPoint, kLargest}) {
    for (const Box& leaf : {kPoint, root}) {
      for (const std::size_t count : {1u, 2u, 8u, 1000u}) {
        const BuildTree tree = flat_tree(root, leaf, count);
        const std::uint32_t rank = bake::rank_of(tree, tree.nodes[0]);
        CHECK(rank >= 1);
        CHECK(rank <= static_cast<std::uint32_t>(kMaxRank));
      }
    }
  }
}

TEST_CASE("the scale of ranks is monotone") {
  for (std::uint32_t measure = 1; measure < 3u << 16; ++measure) {
    REQUIRE(bake::rank_on_scale(measure - 1) <= bake::rank_on_scale(measure));
  }
  CHECK(bake::rank_on_scale((3u << 16) - 1) <= static_cast<std::uint32_t>(kMaxRank));
}
