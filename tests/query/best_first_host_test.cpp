// The fixed traversal against the best one: a search with a heap that visits the nearest pairs of
// boxes first, by equal bounds. It visits no pair farther than the answer.
#include <queue>

#include "flashbvh/clearance.hpp"
#include "support/record.hpp"
#include "support/rotations.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

using namespace flashbvh::detail;

namespace {

/// The nearest pair by box tests alone.
struct BoxNearest : Nearest<std::uint16_t> {
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;
};

struct Pairs {
  Mesh a;
  Mesh b;
  Transform transform;

  Pairs(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose)
      : a(mesh_a), b(mesh_b), transform(pose, mesh_a, mesh_b, /*may_stop=*/false) {
    transform.bring_near();
    transform.prepare(b);
  }
  void take(std::uint32_t i, std::uint32_t j, BoxNearest& nearest) const {
    Triangle of_a;
    Triangle of_b;
    translate_triangle(a, i, kNoOffset, of_a);
    transform_triangle(b, j, transform, of_b);
    if (nearest.take(of_a, of_b)) {
      nearest.nearest_a = static_cast<std::uint16_t>(i);
      nearest.nearest_b = static_cast<std::uint16_t>(j);
    }
  }
};

/// The visits of a query with a pair as hint; `witness`: this pair, then the final one.
std::uint32_t visits_from(const Pairs& pairs, const Pose& pose, Witness<std::uint16_t>& witness,
                          Fraction& least) {
  NearestSoFar so_far(pairs.transform);
  BoxNearest nearest;
  nearest.so_far = &so_far;
  pairs.take(witness.a, witness.b, nearest);
  Query<Ranked<Mesh>, BoxNearest> query(pairs.a, pairs.b, pose, {}, nearest);
  const auto take = [&](const auto&) {
    const auto at = query.last_slots();
    pairs.take(at.a, at.b, nearest);
    return true;
  };
  REQUIRE(query.run(UINT32_MAX, take).status == Status::done);
  least = so_far.least;
  return query.stats().visits;
}

template <class Gap>
std::uint32_t best_first(const Pairs& pairs, Gap gap, Fraction& least,
                         Witness<std::uint16_t>& witness) {
  struct Entry {
    std::uint32_t bound;
    std::uint16_t a;
    std::uint16_t b;
    bool operator<(const Entry& other) const { return bound > other.bound; }
  };
  NearestSoFar so_far(pairs.transform);
  BoxNearest nearest;
  nearest.so_far = &so_far;
  std::priority_queue<Entry> heap;
  std::uint32_t visits = 0;
  const auto visit = [&](std::uint16_t a, std::uint16_t b) {
    ++visits;
    heap.push({gap.nearest(pairs.a.nodes[a].box, pairs.b.nodes[b].box), a, b});
  };
  visit(0, 0);
  while (!heap.empty() && std::int64_t{heap.top().bound} <= so_far.limit) {
    const Entry entry = heap.top();
    heap.pop();
    const auto& node_a = pairs.a.nodes[entry.a];
    const auto& node_b = pairs.b.nodes[entry.b];
    if (node_a.is_leaf() && node_b.is_leaf()) {
      for (auto i = pairs.a.first_triangle(node_a.leaf()); i < pairs.a.end_triangle(node_a.leaf());
           ++i) {
        for (auto j = pairs.b.first_triangle(node_b.leaf());
             j < pairs.b.end_triangle(node_b.leaf()); ++j) {
          pairs.take(i, j, nearest);
        }
      }
      continue;
    }
    const bool into_a = node_a.rank() >= node_b.rank();
    const Mesh& mesh = into_a ? pairs.a : pairs.b;
    const std::uint16_t parent = into_a ? entry.a : entry.b;
    std::uint32_t child = mesh.first_child(parent);
    for (;; child = mesh.next_sibling(child)) {
      const auto at = static_cast<std::uint16_t>(child);
      into_a ? visit(at, entry.b) : visit(entry.a, at);
      if (mesh.is_last_child(parent, child)) {
        break;
      }
    }
  }
  least = so_far.least;
  witness = {nearest.nearest_a, nearest.nearest_b};
  return visits;
}

/// The larger of the two bounds along both frames' axes.
struct TranslatedNearest {
  WideGap gap;
  std::uint32_t nearest(const PackedBox& a, const PackedBox& b) { return gap.squared(a, b); }
};
struct RotatedNearest {
  RotatedGap gap;
  GapLimit limit;
  std::uint32_t nearest(const PackedBox& a, const PackedBox& b) {
    const std::uint32_t on_a = gap.squared(a, b);
    const std::uint32_t on_b = squared_gap(gap.seen_of_a(a), b, limit);
    const std::uint32_t shorter = on_b - (on_b >> 11);
    return shorter > on_a ? shorter : on_a;
  }
};

std::uint32_t best_first(const Pairs& pairs, Fraction& least, Witness<std::uint16_t>& witness) {
  const GapLimit limit((std::int64_t{1} << 30) - 1);  // in whole cells
  if (pairs.transform.is_rotated()) {
    return best_first(pairs, RotatedNearest{RotatedGap(pairs.transform.rotated(), limit), limit},
                      least, witness);
  }
  return best_first(pairs, TranslatedNearest{WideGap(pairs.transform.translated().offset, limit)},
                    least, witness);
}

/// The end of the descent of a query without a hint, and its visits.
std::uint32_t descend(const Pairs& pairs, const Pose& pose, Witness<std::uint16_t>& witness) {
  ClearanceQuery query(pairs.a, pairs.b, pose);
  while (query.result().upper == UINT32_MAX) {
    (void)query.run(1);
  }
  witness = query.result().witness;
  return query.stats().visits;
}

struct Ratio {
  std::uint64_t ours = 0;
  std::uint64_t best = 0;
  double value() const { return static_cast<double>(ours) / static_cast<double>(best); }
};

}  // namespace

TEST_CASE("a seeded query visits what the best order visits, and a cold one little more") {
  const auto bake_ring = [](const bake::LatticeMesh& mesh) {
    return baked(bake::build_default(mesh), mesh);
  };
  const auto a = bake_ring(torus(40, 20, 9000, 3000));
  const auto b = bake_ring(torus(60, 12, 6000, 1500));
  Random random = test_random();
  Ratio seeded;
  Ratio cold;
  // The gap decreases from 30 % of the size to 0.1 %: B moves along a line that grazes A.
  for (const std::int32_t gap : {7000, 2400, 800, 240, 80, 24}) {
    for (int i = 0; i < rounds(2, 8); ++i) {
      const auto rotation = rotation_of(any_quaternion(random));
      const bool turned = i % 2 == 1;
      const auto pose_at = [&](std::int32_t x) {
        const std::int32_t cells[3] = {x, 40 * i, gap / 2 + 100 * i};
        return turned ? Pose::rigid(rotation.entry, cells)
                      : Pose::translated(cells[0], cells[1], cells[2]);
      };
      // From outside to about this distance.
      std::int32_t x = 30000;
      while (x > 0 && distance(a.view(), b.view(), pose_at(x - gap / 4 - 1)).lower / 256 >
                          static_cast<std::uint32_t>(gap)) {
        x -= gap / 4 + 1;
      }
      Witness<std::uint16_t> witness = distance(a.view(), b.view(), pose_at(x + 40)).witness;
      for (int step = 0; step < 5; ++step) {
        const Pose pose = pose_at(x + 32 - 8 * step);
        const Pairs pairs(a.view(), b.view(), pose);
        Fraction truth = kInfinite;
        Fraction least = kInfinite;
        Witness<std::uint16_t> best;
        Witness<std::uint16_t> guessed;
        const std::uint32_t fewest = best_first(pairs, truth, best);
        const std::uint32_t descent = descend(pairs, pose, guessed);
        cold.ours += descent + visits_from(pairs, pose, guessed, least);
        REQUIRE(compare(least, truth) == 0);
        seeded.ours += visits_from(pairs, pose, witness, least);
        REQUIRE(compare(least, truth) == 0);
        seeded.best += fewest;
        cold.best += fewest;
        witness = distance(pairs.a, pairs.b, pose, witness).witness;
      }
    }
  }
  WARN("visits of the best order times " << seeded.value() << " seeded, " << cold.value()
                                         << " cold");
  CHECK(seeded.value() <= 1.05);
  CHECK(cold.value() <= 1.5);
}
