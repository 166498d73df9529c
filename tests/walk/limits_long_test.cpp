// The largest possible 16-bit tree: 65,535 nodes, triangles and vertices, so index 65,534 of each.
#include "bake/image_bytes.hpp"
#include "flashbvh/image.hpp"
#include "support/queries.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

constexpr std::uint32_t kMost = 65535;

/// A strip of triangles along the vertices of a 256 x 256 grid.
bake::LatticeMesh largest_mesh() {
  Random random(3);
  bake::LatticeMesh mesh;
  for (std::uint32_t i = 0; i < kMost; ++i) {
    mesh.vertices.push_back({static_cast<std::int16_t>(i % 256 * 40 - 5000),
                             static_cast<std::int16_t>(i / 256 * 40 - 5000),
                             static_cast<std::int16_t>(random.between(-20, 20))});
    mesh.triangles.push_back({i, (i + 1) % kMost, (i + 2) % kMost});
  }
  return mesh;
}

/// Three triangles across the strip, one of them through its last triangles.
bake::LatticeMesh probe() {
  bake::LatticeMesh mesh;
  mesh.vertices = {{5100, 5180, -100}, {5250, 5190, 100},  {5000, 5250, 100},
                   {-4990, -4990, -9}, {-4800, -4900, 30}, {-4900, -4700, 0},
                   {0, 0, -500},       {900, 0, 500},      {0, 900, 500}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  return mesh;
}

}  // namespace

TEST_CASE("index 65,534 of nodes, triangles and vertices is as good as any") {
  const bake::LatticeMesh mesh = largest_mesh();
  const bake::LatticeMesh small = probe();
  const bake::BuildTree tree = bake::build_median(mesh, 2);
  REQUIRE(tree.nodes.size() == kMost);
  REQUIRE(bake::fits_index<std::uint16_t>(tree, mesh));
  const Pose here = Pose::translated(0, 0, 0);
  const Pairs truth = brute_force(mesh, small, here);
  REQUIRE(truth.back().first == kMost - 1);

  const bake::BuildTree small_tree = bake::build_median(small, 1);
  const auto post_a = baked(tree, mesh);
  const auto post_b = baked(small_tree, small);
  check_pairs(post_a.view(), post_b.view(), here, truth);
  const auto pre_a = baked<Layout::pre_indexed>(tree, mesh);
  const auto pre_b = baked<Layout::pre_indexed>(small_tree, small);
  check_pairs(pre_a.view(), pre_b.view(), here, truth);

  const auto image = bake::image_of(post_a, true);
  MeshWithLevels opened;
  REQUIRE(open_image(image.data(), image.size() * sizeof image[0], opened) == Status::done);
  check_pairs(opened, post_b.view(), here, truth);
}

TEST_CASE("a tree too large for its indices is refused before it is laid out") {
  bake::LatticeMesh mesh = largest_mesh();
  CHECK_FALSE(bake::fits_index<std::uint16_t>(bake::build_median(mesh, 1), mesh));
  mesh.vertices.push_back({0, 0, 999});
  CHECK_FALSE(bake::fits_index<std::uint16_t>(bake::build_median(mesh, 2), mesh));
  CHECK(bake::fits_index<std::uint32_t>(bake::build_median(mesh, 2), mesh));
}
