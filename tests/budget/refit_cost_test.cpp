// What it takes to refit a sheet, and to ask it about itself at rest and crumpled, counted on the
// target.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/bending.hpp"
#include "deformable/bending.hpp"
#include "flashbvh/self.hpp"
#include "insn.hpp"
#include "stack.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

/// Of a Cortex-M7 at 480 MHz and 100 Hz, at an instruction a cycle.
[[maybe_unused]] constexpr std::uint32_t kHalfAFrame = 2'400'000;
/// Bytes of stack, of a refit.
constexpr std::uint32_t kMostStack = 256;
/// Of self queries, their objects in the callers' frames included.
constexpr std::uint32_t kMostSelfStack = 720;
constexpr std::uint32_t kMostBandStack = 880;

std::uint32_t cost_of_refit(BasicDeformableMesh<PostMesh>& mesh) {
  RefitStep step{};
  const std::uint32_t cost = port::instructions_of([&] { step = mesh.refit(); });
  CHECK(step.status == Status::done);
  return cost;
}

std::uint32_t cost_of_self(const PostMesh& mesh, Counts& counts) {
  return port::instructions_of([&] {
    SelfQuery query(mesh);
    (void)query.run(UINT32_MAX, [](const SelfQuery::Pair&) { return true; });
    counts = query.counts();
  });
}

/// The queries are the caller's memory, as everywhere.
Status ask_itself(Bending<PostMesh>& bent) {
  static SelfQuery query(bent.mesh.mesh());
  query = SelfQuery(bent.mesh.mesh());
  return query.run(UINT32_MAX, [](const SelfQuery::Pair&) { return true; });
}
Status ask_band(Bending<PostMesh>& bent) {
  static SelfWithinQuery query(bent.mesh.mesh());
  query = SelfWithinQuery(bent.mesh.mesh(), within(20 * 256));
  return query.run(UINT32_MAX, [](const SelfWithinQuery::Pair&) { return true; });
}

}  // namespace

TEST_CASE("a refit keeps to what flashbvh info says of it, and a sheet is asked in half a frame") {
  Random random(3);
  bake::LatticeMesh lattice = grid(22, 23, false);
  lay(random, 23, 500, 0, 0, lattice.vertices.data(), lattice.vertices.size());
  struct Tree {
    std::uint32_t leaf_size;
    std::uint32_t arity;
  };
  for (const Tree& tree : {Tree{1, 2}, Tree{1, 4}, Tree{bake::kDefaultLeafSize, 4}, Tree{4, 4}}) {
    Bending<PostMesh> bent(bake::collapse(bake::build_sah(lattice, tree.leaf_size), tree.arity),
                           lattice);
    Counts counts{};
    const std::uint32_t refit = cost_of_refit(bent.mesh);
    const std::uint32_t rest = cost_of_self(bent.mesh.mesh(), counts);
    lay(random, 23, 320, 300, 210, bent.vertices.data(), bent.vertices.size());
    (void)cost_of_refit(bent.mesh);
    const std::uint32_t crumpled = cost_of_self(bent.mesh.mesh(), counts);
    const auto nodes = static_cast<std::uint32_t>(bent.nodes.size());
    const std::size_t told = bake::bending_cost(bent.mesh.mesh()).refit_instructions;
    std::printf(
        "budget: leaf size %u, arity %u: %u nodes, %u bytes of RAM; refit %u instructions (told "
        "%u), "
        "%.1f a node; itself at rest %u, crumpled %u (%u pairs)\n",
        static_cast<unsigned>(tree.leaf_size), static_cast<unsigned>(tree.arity),
        static_cast<unsigned>(nodes),
        static_cast<unsigned>(nodes * sizeof bent.nodes[0] +
                              bent.vertices.size() * sizeof bent.vertices[0]),
        static_cast<unsigned>(refit), static_cast<unsigned>(told),
        static_cast<double>(refit) / nodes, static_cast<unsigned>(rest),
        static_cast<unsigned>(crumpled), static_cast<unsigned>(counts.triangle_pairs));
    std::fflush(stdout);
#if defined(__ARM_ARCH_7EM__)
    CHECK(refit <= told + told / 8);
    CHECK(refit >= told - told / 8);
    if (tree.leaf_size == bake::kDefaultLeafSize) {
      CHECK(refit + rest <= kHalfAFrame);
      CHECK(refit + crumpled <= kHalfAFrame);
    }
#endif
    const std::uint32_t of_refit = port::stack_of([&] { (void)bent.mesh.refit(); });
    const std::uint32_t of_self = port::stack_of([&] { (void)ask_itself(bent); });
    const std::uint32_t of_band = port::stack_of([&] { (void)ask_band(bent); });
    std::printf("budget: stack of a refit %u, of a self query %u, of a band %u\n",
                static_cast<unsigned>(of_refit), static_cast<unsigned>(of_self),
                static_cast<unsigned>(of_band));
    CHECK(of_refit <= kMostStack);
    CHECK(of_self <= kMostSelfStack);
    CHECK(of_band <= kMostBandStack);
  }
}
