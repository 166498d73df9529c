// The stack of a query, painted and measured on the target, and the memory it is allowed.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "stack.hpp"
#include "support/torus.hpp"

using namespace flashbvh;

namespace {

/// A query's stack, from the call of run() down.
constexpr std::uint32_t kMostStack = 256;
/// The caller's part of a query.
constexpr std::size_t kMostObject = 96;

using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

Baked baked(const bake::LatticeMesh& mesh) {
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_median(mesh, 1), mesh);
}

/// The most that a run of 50 visits takes on the way to the end.
std::uint32_t stack_of_query(const Baked& a, const Baked& b, const Pose& pose) {
  const auto tree_a = a.view();
  const auto tree_b = b.view();
  PairQuery query(tree_a, tree_b, pose);
  PairQuery::Pair found[4];
  Step step{};
  std::uint32_t most = 0;
  do {
    const std::uint32_t used = port::stack_of([&] { step = query.run(50, found); });
    most = used > most ? used : most;
  } while (step.status == Status::suspended || step.status == Status::full);
  return most;
}

/// Two squares in one plane, of coordinates so large that no shortcut applies.
bake::LatticeMesh square() {
  bake::LatticeMesh mesh;
  mesh.vertices = {{-16000, -16000, 0}, {16000, -15000, 0}, {16000, 16000, 0}, {-15000, 16000, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("a query's stack stays within its budget") {
  const Baked torus = baked(test::torus(20, 20, 6000, 2000));
  const Baked plane = baked(square());
  const std::uint32_t general = stack_of_query(torus, torus, Pose::translated(3000, 1000, 500));
  const std::uint32_t coplanar = stack_of_query(plane, plane, Pose::translated(1000, 500, 0));
  const std::uint32_t separated = stack_of_query(torus, torus, Pose::translated(30000, 0, 0));
  std::printf("stack of a query: %u bytes, %u between coplanar triangles, %u if separated\n",
              static_cast<unsigned>(general), static_cast<unsigned>(coplanar),
              static_cast<unsigned>(separated));
  std::printf("query object: %u bytes\n", static_cast<unsigned>(sizeof(PairQuery)));
  std::fflush(stdout);
  CHECK(general <= kMostStack);
  CHECK(coplanar <= kMostStack);
  CHECK(separated <= kMostStack);
  CHECK(sizeof(PairQuery) <= kMostObject);
}
