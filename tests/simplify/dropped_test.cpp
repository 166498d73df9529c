// The deviation that baking tells, with dropped triangles, against samples of both meshes.
#include "image/baking.hpp"
#include "simplify/zoo.hpp"

using namespace flashbvh::test;
using tool::BakedMesh;
using tool::BakeOptions;
using tool::InputMesh;

namespace {

using BakedOne = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

/// Triangles of all kinds on eighths of a cell: many needles, lines and points, and repeated ones.
bake::SourceMesh any_soup(Random& random) {
  bake::SourceMesh mesh;
  const auto any_point = [&] {
    simplify::Point p;
    for (double& coordinate : p) {
      coordinate = random.between(-80, 80) / 8.0;
    }
    return p;
  };
  const auto near = [&](simplify::Point p, std::int32_t eighths) {
    for (double& coordinate : p) {
      coordinate += random.between(-eighths, eighths) / 8.0;
    }
    return p;
  };
  const std::uint32_t count = 2 + random.below(8);
  for (std::uint32_t i = 0; i < count; ++i) {
    const simplify::Point p = any_point();
    const simplify::Point q = random.below(4) == 0 ? near(p, 2) : any_point();
    simplify::Point middle;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle[axis] = (p[axis] + q[axis]) / 2;
    }
    simplify::Point r = any_point();
    const std::uint32_t kind = random.below(4);
    r = kind == 0 ? r : near(kind == 1 ? q : middle, kind == 3 ? 0 : 2);
    const std::uint32_t copies = 1 + (random.below(3) == 0 ? 1 : 0);
    for (std::uint32_t copy = 0; copy < copies; ++copy) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(near(p, static_cast<std::int32_t>(copy)));
      mesh.vertices.push_back(q);
      mesh.vertices.push_back(r);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return mesh;
}

bake::SourceMesh mesh_of(const BakedOne& tree) {
  bake::SourceMesh mesh;
  for (const Vertex& v : tree.vertices) {
    mesh.vertices.push_back({(v.x + tree.origin[0]) * tree.cell, (v.y + tree.origin[1]) * tree.cell,
                             (v.z + tree.origin[2]) * tree.cell});
  }
  for (const auto& triangle : tree.triangles) {
    mesh.triangles.push_back({triangle.corner[0], triangle.corner[1], triangle.corner[2]});
  }
  return mesh;
}

/// The largest distance of corners and samples of one mesh from the other, and the reverse.
double sampled(const bake::SourceMesh& a, const bake::SourceMesh& b, int samples, Random& random) {
  double most = 0;
  for (const auto& [of, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& vertex : of->vertices) {
      most = std::max(most, distance_by_force(vertex, *to));
    }
    for (int i = 0; i < samples; ++i) {
      most = std::max(most, distance_by_force(any_point_of(random, *of), *to));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("no point of the file is farther from the image than told, dropped triangles included") {
  int dropped = 0;
  int on_others = 0;
  for_rounds(rounds(400, 20'000), [&](Random& random, int) {
    const bake::SourceMesh soup = any_soup(random);
    const InputMesh input = tool::input_of("", soup, tool::degenerate_triangles(soup));
    BakeOptions options;
    options.cell = 0.5;
    options.drop_degenerate = random.below(4) != 0;
    options.drop_duplicate = random.below(2) == 0;
    const bool is_long = random.below(2) == 1;
    const double length = (is_long ? 1 : 0) * random.between(1, 20) / 4.0;
    CAPTURE(options.drop_degenerate, options.drop_duplicate, length);
    simplify::Coarsening coarse(input.mesh, *options.cell);
    coarse.coarsen(std::max(length, coarse.rounding()));
    const std::size_t most = (length > 0 ? coarse.mesh() : input.mesh).triangles.size();
    std::optional<BakedMesh> baked;
    try {
      baked = length > 0 ? tool::bake(input, options, coarse) : tool::bake(input, options);
    } catch (const tool::UserError&) {
      return;  // nothing is left
    }
    const BakedOne& tree = std::get<BakedOne>(baked->tree);
    const double truth = sampled(input.mesh, mesh_of(tree), 60, random);
    REQUIRE(tree.deviation >= truth);
    REQUIRE(tree.view().deviation_sixteenths * tree.cell / 16 >= tree.deviation);
    if (tree.triangles.size() < most) {
      dropped += baked->dropped > 0 ? 1 : 0;
      on_others += baked->dropped > 0 ? 0 : 1;
      if (length == 0) {  // tight, but for rounding: half a diagonal, in and out
        REQUIRE(tree.deviation <= 1.25 * truth + 2 * tree.cell);
      }
    }
  });
  CHECK(dropped > 0);
  CHECK(on_others > 0);
}

TEST_CASE("triangles that lie on others are dropped without deviation") {
  // A needle along the diagonal, one along half an edge, a point, and a triangle turned over.
  const bake::SourceMesh mesh = {
      {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 0}, {4, 4, 0}, {0, 4, 0}},
      {{0, 1, 2}, {2, 1, 3}, {1, 2, 4}, {2, 5, 5}, {3, 3, 3}, {0, 2, 1}}};
  BakeOptions options;
  options.cell = 0.5;
  options.drop_degenerate = options.drop_duplicate = true;
  const BakedMesh baked =
      tool::bake(tool::input_of("", mesh, tool::degenerate_triangles(mesh)), options);
  const BakedOne& tree = std::get<BakedOne>(baked.tree);
  CHECK(tree.triangles.size() == 2);
  CHECK(tree.deviation < 1e-9);
}
