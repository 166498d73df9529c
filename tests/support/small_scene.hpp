// Two meshes, their trees and a pose in 4 KB of stack, and their intersecting pairs of triangles,
// for tests that run on every board.
#pragma once

#include <stdint.h>
#include <string.h>

#include <catch2/catch.hpp>

#include "digest/small_mesh.hpp"
#include "digest/small_tree.hpp"
#include "flashbvh/query.hpp"
#include "support/at_roots.hpp"
#include "support/compiled_queries.hpp"
#include "support/transformed_vertex.hpp"

namespace flashbvh::test {

using Pair = TrianglePair<uint16_t>;
constexpr uint32_t kNoLimit = UINT32_MAX;

template <Layout layout>
struct SmallScene {
  digest::SmallMesh mesh_a, mesh_b;
  digest::SmallTree<layout> a, b;
  Pose pose;

  explicit SmallScene(Random& random) : pose(Pose::translated(0, 0, 0)) {
    const digest::Scale& scale = random.one_of(digest::kScales);
    make(random, scale, mesh_a, a);
    make(random, scale, mesh_b, b);
    pose = digest::any_pose(random, scale);
  }

 private:
  static void make(Random& random, const digest::Scale& scale, digest::SmallMesh& mesh,
                   digest::SmallTree<layout>& tree) {
    digest::make_mesh(random, scale, mesh);
    const auto shape = static_cast<digest::Shape>(random.below(4));
    REQUIRE(tree.make(mesh, shape, 1 + random.below(3)));
  }
};

/// A set of pairs of triangles.
class PairSet {
 public:
  /// Adds a pair; false if the set has it.
  bool add(uint32_t a, uint32_t b) {
    const uint32_t before = rows_[a];
    rows_[a] |= 1u << b;
    return rows_[a] != before;
  }
  bool has(uint32_t a, uint32_t b) const { return (rows_[a] >> b & 1u) != 0; }
  friend bool operator==(const PairSet& p, const PairSet& q) {
    return memcmp(p.rows_, q.rows_, sizeof p.rows_) == 0;
  }

 private:
  static_assert(digest::kMostTriangles <= 32, "a bit for each");
  uint32_t rows_[digest::kMostTriangles] = {};
};

template <Layout layout>
PairSet brute_force(const SmallScene<layout>& scene) {
  PairSet pairs;
  brute_force(scene.mesh_a, scene.mesh_a.triangle_count, scene.mesh_b, scene.mesh_b.triangle_count,
              scene.pose, [&pairs](uint32_t i, uint32_t j) { (void)pairs.add(i, j); });
  return pairs;
}

/// All pairs of a query, from runs of `work`; each is reported once.
template <class Query>
PairSet all_pairs(Query& query, uint32_t work = kNoLimit) {
  PairSet pairs;
  bool twice = false;
  const auto add = [&](const Pair& pair) {
    twice = !pairs.add(pair.a, pair.b) || twice;
    return true;
  };
  while (query.run(work, add).status == Status::suspended) {
  }
  REQUIRE(query.status() == Status::done);
  REQUIRE_FALSE(twice);
  return pairs;
}

/// A query of any traversal; those with a stack get exactly the promised entries.
template <class Traversal>
struct SmallQuery {
  detail::PairCursor<uint16_t> entries[Traversal::kStackless ? 1 : 2 * digest::kMostTriangles];
  Query<Traversal> query;

  template <class Scene>
  explicit SmallQuery(const Scene& scene)
      : query(scene.a.view(), scene.b.view(), scene.pose,
              at_roots<Traversal>(
                  entries, stack_entries(scene.a.view().stack_need, scene.b.view().stack_need))) {}
};

}  // namespace flashbvh::test
