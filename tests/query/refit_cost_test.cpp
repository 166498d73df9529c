// The instructions to refit a sheet, and to query it against itself at rest and crumpled, counted
// on the target.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>

#include "bake/bending.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/time_bound.hpp"
#include "insn.hpp"
#include "support/bending.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

/// Half a frame of a Cortex-M7 at 480 MHz and 100 Hz, at one instruction per cycle.
[[maybe_unused]] constexpr std::uint32_t kHalfAFrame = 2'400'000;
std::uint32_t cost_of_refit(BasicDeformableMesh<Mesh>& mesh) {
  RefitResult step{};
  const std::uint32_t cost = port::instructions_of([&] { step = mesh.refit(); });
  CHECK(step.status == Status::done);
  return cost;
}

std::uint32_t cost_of_self(const Mesh& mesh, QueryStats& counts) {
  return port::instructions_of([&] {
    SelfQuery query(mesh);
    (void)query.run(UINT32_MAX, [](const SelfQuery::Pair&) { return true; });
    counts = query.stats();
  });
}

/// The largest cost of a run with this budget.
[[maybe_unused]] std::uint32_t worst_run(const Mesh& mesh, std::uint32_t work) {
  SelfQuery query(mesh);
  std::uint32_t most = 0;
  SelfQuery::Pair found[8];
  while (query.status() == Status::suspended) {
    most = std::max(most, port::instructions_of([&] { (void)query.run(work, found); }));
  }
  return most;
}

}  // namespace

TEST_CASE(
    "a refit keeps to what flashbvh info says of it, and queries of a sheet take half a frame") {
  Random random(3);
  bake::LatticeMesh lattice = grid(22, 23, false);
  lay(random, 23, 500, 0, 0, lattice.vertices.data(), lattice.vertices.size());
  struct Tree {
    std::uint32_t leaf_size;
    std::uint32_t arity;
    bool shows_quads = true;
  };
  for (const Tree& tree : {Tree{1, 2}, Tree{1, 4}, Tree{bake::kDefaultLeafSize, 4}, Tree{4, 4},
                           Tree{bake::kDefaultLeafSize, 4, false}}) {
    Bending<Mesh> bent(bake::collapse(bake::build_sah(lattice, tree.leaf_size), tree.arity),
                       lattice, tree.shows_quads);
    QueryStats counts{};
    const std::uint32_t refit = cost_of_refit(bent.mesh);
    const std::uint32_t rest = cost_of_self(bent.mesh.mesh(), counts);
    lay(random, 23, 320, 300, 210, bent.vertices.data(), bent.vertices.size());
    (void)cost_of_refit(bent.mesh);
#if defined(__ARM_ARCH_7EM__)
    for (const std::uint32_t work : {40u, 400u}) {
      if (tree.leaf_size != bake::kDefaultLeafSize || !tree.shows_quads) {
        continue;
      }
      const TreeSize size = {bent.baked.depth, bent.baked.arity, bent.baked.leaf_size,
                             bent.baked.leaf_count,
                             static_cast<std::uint32_t>(bent.baked.triangles.size())};
      const std::uint64_t bound = most_instructions(kCortexM4F, size, size, work);
      const std::uint32_t most = worst_run(bent.mesh.mesh(), work);
      std::printf("budget: a self query's run of work %u: %u at most, of %u\n",
                  static_cast<unsigned>(work), static_cast<unsigned>(most),
                  static_cast<unsigned>(bound));
      CHECK(most <= bound);
    }
#endif
    const std::uint32_t crumpled = cost_of_self(bent.mesh.mesh(), counts);
    const auto nodes = static_cast<std::uint32_t>(bent.nodes.size());
    const std::size_t promised = bake::bending_cost(bent.mesh.mesh()).refit_instructions;
    std::printf(
        "budget: leaf size %u, arity %u: %u nodes, %u bytes of RAM; refit %u instructions "
        "(promised "
        "%u), "
        "%.1f a node; itself at rest %u, crumpled %u (%u pairs)\n",
        static_cast<unsigned>(tree.leaf_size), static_cast<unsigned>(tree.arity),
        static_cast<unsigned>(nodes),
        static_cast<unsigned>(nodes * sizeof bent.nodes[0] +
                              bent.vertices.size() * sizeof bent.vertices[0]),
        static_cast<unsigned>(refit), static_cast<unsigned>(promised),
        static_cast<double>(refit) / nodes, static_cast<unsigned>(rest),
        static_cast<unsigned>(crumpled), static_cast<unsigned>(counts.triangle_pairs));
    std::fflush(stdout);
#if defined(__ARM_ARCH_7EM__)
    CHECK(refit <= promised + promised / 20);
    CHECK(refit >= promised - promised / 20);
    if (tree.leaf_size == bake::kDefaultLeafSize) {
      CHECK(refit + rest <= kHalfAFrame);
      CHECK(refit + crumpled <= kHalfAFrame);
    }
#endif
  }
}
