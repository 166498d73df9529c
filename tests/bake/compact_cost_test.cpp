// Flash saved, and instructions added, by several triangles in a leaf, counted on the target.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/image_bytes.hpp"
#include "flashbvh/collide.hpp"
#include "insn.hpp"
#include "support/points.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/torus.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace {

using Baked = test::Baked<Layout::post_indexed>;

Baked compact(const bake::LatticeMesh& mesh, std::uint32_t leaf_size) {
  return test::baked(bake::collapse(bake::build_sah(mesh, leaf_size), bake::kDefaultArity), mesh);
}

struct Cost {
  std::uint32_t instructions = 0;
  std::uint32_t visits = 0;
};

Pose any_translation(test::Random& random, std::int32_t reach) {
  const Point to = test::any_point(random, reach);
  return Pose::translated(to.x, to.y, to.z);
}

Cost cost_of(const Mesh& a, const Mesh& b, std::int32_t reach) {
  test::Random random = test::test_random();
  Cost cost;
  for (int i = 0; i < 20; ++i) {
    const Pose pose = i < 10 ? test::any_rigid_pose(random, reach) : any_translation(random, reach);
    PairQuery query(a, b, pose);
    cost.instructions += port::instructions_of(
        [&] { (void)query.run(UINT32_MAX, [](const PairQuery::Pair&) { return true; }); });
    cost.visits += query.stats().visits;
  }
  return cost;
}

/// The compact form of the documents: five triangles per leaf.
constexpr std::uint32_t kCompact = 5;
constexpr double kMostBytes = 20;
constexpr double kMostInstructions = 1.3;

/// Bytes per triangle of an image without levels, which only the paper's alternating rule uses.
double bytes_per_triangle(const Baked& baked) {
  return static_cast<double>(bake::image_size(baked)) / static_cast<double>(baked.triangles.size());
}

}  // namespace

TEST_CASE("a leaf of five keeps within the compact form's budget") {
  const bake::LatticeMesh mesh_a = test::torus(20, 20, 6000, 2000);
  const bake::LatticeMesh mesh_b = test::torus(40, 10, 7000, 800);
  std::uint32_t usual = 0;
  constexpr std::uint32_t kLeafSizes[] = {1, 2, kCompact, 8};
  for (const std::uint32_t leaf_size : kLeafSizes) {
    const Baked a = compact(mesh_a, leaf_size);
    const Baked b = compact(mesh_b, leaf_size);
    const Cost cost = cost_of(a.view(), b.view(), 9000);
    usual = leaf_size == 1 ? cost.instructions : usual;
    const double bytes = bytes_per_triangle(a);
    const double part = static_cast<double>(cost.instructions) / usual;
    std::printf(
        "budget: leaf size %u: %5.2f bytes a triangle, %8u visits, %4.2f of the "
        "instructions of leaf size 1\n",
        static_cast<unsigned>(leaf_size), bytes, static_cast<unsigned>(cost.visits), part);
    std::fflush(stdout);
    if (leaf_size == kCompact) {
      CHECK(bytes <= kMostBytes);
      CHECK(part <= kMostInstructions);
    }
  }
}
