// What several triangles in a leaf save in flash, and cost in instructions, counted on the target.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/baked_tree.hpp"
#include "bake/build_tree.hpp"
#include "bake/image_bytes.hpp"
#include "flashbvh/collide.hpp"
#include "insn.hpp"
#include "support/rotations.hpp"
#include "support/torus.hpp"

using namespace flashbvh;

namespace {

using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

Baked baked(const bake::LatticeMesh& mesh, std::uint32_t leaf_size, std::uint32_t arity) {
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(
      bake::collapse(bake::build_sah(mesh, leaf_size), arity), mesh);
}

struct Cost {
  std::uint32_t instructions = 0;
  std::uint32_t pairs = 0;
  std::uint32_t leaf_pairs = 0;
  std::uint32_t visits = 0;
};

Cost cost_of(const PostTree& a, const PostTree& b, std::int32_t reach) {
  test::Random random(test::test_seed());
  Cost cost;
  for (int i = 0; i < 20; ++i) {
    const Pose pose =
        i < 10 ? test::any_rigid_pose(random, reach)
               : Pose::translated(random.between(-reach, reach), random.between(-reach, reach),
                                  random.between(-reach, reach));
    PairQuery query(a, b, pose);
    cost.instructions += port::instructions_of(
        [&] { (void)query.run(UINT32_MAX, [](const PairQuery::Pair&) { return true; }); });
    cost.pairs += query.counts().triangle_pairs;
    cost.visits += query.counts().visits;
    cost.leaf_pairs += query.counts().leaf_pairs;
  }
  return cost;
}

}  // namespace

TEST_CASE("several triangles in a leaf") {
  const bake::LatticeMesh mesh_a = test::torus(20, 20, 6000, 2000);
  const bake::LatticeMesh mesh_b = test::torus(40, 10, 7000, 800);
  for (const std::uint32_t leaf_size : {1u, 2u, 3u, 4u, 6u, 8u}) {
    for (const std::uint32_t arity : {2u, 4u}) {
      const Baked a = baked(mesh_a, leaf_size, arity);
      const Baked b = baked(mesh_b, leaf_size, arity);
      const auto bytes = bake::image_size(a) - 4 * a.nodes.size();
      std::printf("leaf %u arity %u: %5.2f bytes/triangle", static_cast<unsigned>(leaf_size),
                  static_cast<unsigned>(arity),
                  static_cast<double>(bytes) / static_cast<double>(mesh_a.triangles.size()));
      for (const std::int32_t reach : {6000, 12000}) {
        const Cost cost = cost_of(a.view(), b.view(), reach);
        std::printf("  | %9u instructions %6u visits %6u leaf pairs %6u pairs",
                    static_cast<unsigned>(cost.instructions), static_cast<unsigned>(cost.visits),
                    static_cast<unsigned>(cost.leaf_pairs), static_cast<unsigned>(cost.pairs));
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}
