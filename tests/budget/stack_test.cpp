// The stack of a query, painted and measured on the target, and the memory it is allowed.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "stack.hpp"
#include "support/rotations.hpp"
#include "support/torus.hpp"

using namespace flashbvh;

namespace {

/// A query's stack, from the call of run() down. Turning boxes takes more registers without the
/// DSP extension.
#if defined(__ARM_FEATURE_DSP)
constexpr std::uint32_t kMostStack = 256;
#else
constexpr std::uint32_t kMostStack = 288;
#endif
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
  const std::int32_t moved[3] = {3000, 1000, 500};
  const Pose turned = Pose::rigid(test::rotation_of({7, 3, -2, 5}).entry, moved);
  const Pose quarter = Pose::rigid(test::rotation_of({1, 0, 0, 1}).entry, {1000, 500, 0});
  const Pose translated = Pose::translated(3000, 1000, 500);
  const struct {
    const char* what;
    const Baked& mesh;
    const Pose& pose;
  } queries[] = {{"tori, moved", torus, translated},
                 {"tori, turned", torus, turned},
                 {"coplanar triangles, moved", plane, Pose::translated(1000, 500, 0)},
                 {"coplanar triangles, turned", plane, quarter},
                 {"separated, moved", torus, Pose::translated(30000, 0, 0)}};
  for (const auto& query : queries) {
    const std::uint32_t most = stack_of_query(query.mesh, query.mesh, query.pose);
    std::printf("budget: stack of a query, %s: %u bytes, at most %u\n", query.what,
                static_cast<unsigned>(most), static_cast<unsigned>(kMostStack));
    CHECK(most <= kMostStack);
  }
  std::printf("budget: query object: %u bytes, at most %u\n",
              static_cast<unsigned>(sizeof(PairQuery)), static_cast<unsigned>(kMostObject));
  std::fflush(stdout);
  CHECK(sizeof(PairQuery) <= kMostObject);
}
