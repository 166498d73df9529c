// A reported pair, transformed again by its ids, and its contact inside a query.
#include "flashbvh/contact.hpp"

#include <catch2/catch.hpp>

#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "support/points.hpp"
#include "support/rotations.hpp"
#include "support/torus.hpp"
#include "support/transformed_mesh.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;
using Pair = PairQuery::Pair;
using flashbvh::test::same;

Baked baked(const bake::LatticeMesh& mesh) {
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_median(mesh, 3), mesh);
}

bake::LatticeMesh ring() {
  bake::LatticeMesh mesh = torus(8, 6, 600, 250);
  mesh.origin = {1000, -200, 30};
  return mesh;
}

/// How many pairs the query reports; each is transformed again as the query has it, inside a sink.
std::uint32_t check_pairs(const Mesh& a, const Mesh& b, const Pose& pose) {
  PairQuery query(a, b, pose);
  std::uint32_t pairs = 0;
  std::uint32_t wrong = 0;
  const RunResult step = query.run(UINT32_MAX, [&](const Pair& pair) {
    Triangle last[2];
    Triangle again[2];
    query.last_pair(last[0], last[1]);
    const bool found = transform_pair(a, b, pose, pair, again[0], again[1]);
    const bool equal = found && same(last[0], again[0]) && same(last[1], again[1]) &&
                       same_place(contact_of_last(query), contact_of(again[0], again[1]));
    wrong += equal ? 0u : 1u;
    ++pairs;
    return true;
  });
  CHECK(step.status == Status::done);
  CHECK(wrong == 0);
  return pairs;
}

}  // namespace

TEST_CASE("contact: a reported pair is transformed again as the query had it", "[contact]") {
  const Baked mesh_a = baked(ring());
  const Baked mesh_b = baked(torus(7, 5, 500, 200));
  const Mesh a = mesh_a.view();
  const Mesh b = mesh_b.view();
  CHECK(check_pairs(a, b, Pose::translated(1300, 100, 200)) > 10);
  const Rotation rotation = rotation_of({3, 1, 2, -1});
  const std::int32_t cells[3] = {1400, 50, 100};
  CHECK(check_pairs(a, b, Pose::rigid(rotation.entry, cells)) > 10);
}

TEST_CASE(
    "contact: a pair is transformed to where the pose's definition puts it, intersecting or not",
    "[contact]") {
  const bake::LatticeMesh mesh_a = ring();
  const bake::LatticeMesh mesh_b = torus(7, 5, 500, 200);
  const Baked baked_a = baked(mesh_a);
  const Baked baked_b = baked(mesh_b);
  const Mesh a = baked_a.view();
  const Mesh b = baked_b.view();
  const Rotation rotation = rotation_of({3, 1, 2, -1});
  const std::int32_t cells[3] = {9000, 50, 100};  // far from A
  const Pose pose = Pose::rigid(rotation.entry, cells);
  for (std::uint16_t i = 0; i < b.triangle_count; ++i) {
    Triangle transformed_a;
    Triangle transformed_b;
    REQUIRE(transform_pair(a, b, pose, {0, i}, transformed_a, transformed_b));
    CHECK(same(transformed_b, transformed(mesh_b, i, pose)));
  }
}

TEST_CASE("contact: a pair that no query reports is refused", "[contact]") {
  const Baked baked_a = baked(ring());
  const Mesh a = baked_a.view();
  Mesh b = a;
  const Pose pose = Pose::translated(0, 0, 0);
  const auto count = a.triangle_count;
  const auto last = static_cast<std::uint16_t>(count - 1);
  Triangle transformed[2];
  CHECK(transform_pair(a, b, pose, {last, last}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, pose, {count, 0}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, pose, {0, count}, transformed[0], transformed[1]));
  CHECK_FALSE(transform_pair(a, b, Pose::translated(INT32_MAX, 0, 0), {0, 0}, transformed[0],
                             transformed[1]));
  b.cell_bits ^= 1;
  CHECK_FALSE(transform_pair(a, b, pose, {0, 0}, transformed[0], transformed[1]));
}
