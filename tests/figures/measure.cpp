#include "measure.hpp"

#include "flashbvh/detail/predicates/triangle.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

constexpr auto kEveryPair = [](const PairQuery::Pair&) { return true; };
constexpr auto kNoLeafPair = [](uint32_t, uint32_t) {};

/// Returns one visit if the roots alone show that the meshes are disjoint.
template <class Shapes, class LeafPair>
Walked walk_pose(const Mesh& a, const Mesh& b, const Pose& pose, const LeafPair& leaf_pair) {
  Transform transform(pose, a, b, /*may_stop=*/true);
  if (transform.roots_disjoint()) {
    return {1, 0, 0};
  }
  transform.prepare(b);
  if (transform.is_rotated()) {
    RotatedBoxTest bound(transform.rotated());
    Shapes shapes(a, b, transform);
    shapes.set_box_test(bound);
    return measure_walk(ByReference<RotatedBoxTest>{&bound}, shapes, leaf_pair);
  }
  Shapes shapes(a, b, transform);
  return measure_walk(transform.translated().bound, shapes, leaf_pair);
}

/// Leaf planes whose slabs are computed twice, or counted: the difference is the slabs' cost.
template <bool kCounted>
class MadeTwice : public LeafPlanes<Mesh> {
 public:
  using LeafPlanes::LeafPlanes;

  static uint32_t slabs;

  bool begin(Side side, uint32_t node, const PackedBox* reached) {
    if (!is_taken(side, node)) {
      (void)LeafPlanes::begin(side, node, reached);
      if (kCounted) {
        slabs += made_;
      }
      node_ = nullptr;
    }
    return LeafPlanes::begin(side, node, reached);
  }
};
template <bool kCounted>
uint32_t MadeTwice<kCounted>::slabs;

/// Adds the parts of a walk of more than one visit; returns the walk.
Walked add_walks(const FigureNames& names, const Mesh& a, const Mesh& b, const Pose& pose) {
  const Walked all = walk_pose<LeafPlanes<Mesh>>(a, b, pose, kNoLeafPair);
  if (all.visits > 1) {
    const Walked inner = walk_pose<NothingBelow>(a, b, pose, kNoLeafPair);
    const Walked twice = walk_pose<MadeTwice<false>>(a, b, pose, kNoLeafPair);
    MadeTwice<true>::slabs = 0;
    (void)walk_pose<MadeTwice<true>>(a, b, pose, kNoLeafPair);
    add_quotient(names.part("visit"), inner.instructions, inner.visits);
    add_quotient(names.part("leaf_visit"), int64_t{all.instructions} - inner.instructions,
                 all.visits - inner.visits);
    add_quotient(names.part("slab"), int64_t{twice.instructions} - all.instructions,
                 MadeTwice<true>::slabs);
  }
  return all;
}

}  // namespace

bool add_query(const FigureNames& names, const Mesh& a, const Mesh& b, const Pose& pose,
               QueryStats& counts, uint32_t& work) {
  Status status{};
  const uint32_t whole = measure(names.whole("query"), [&] {
    PairQuery query(a, b, pose);
    status = query.run(UINT32_MAX, kEveryPair).status;
  });
  (void)add_first(names, a, b, pose);
  // Counts come from another run: a caller of the first run would not copy them.
  PairQuery query(a, b, pose);
  constexpr uint32_t kGranted = UINT32_MAX - 1;  // which counts as a limit
  work = query.run(kGranted, kEveryPair).work;
  counts = query.stats();
  add_count(names.whole("visits"), counts.visits);
  add_to_digest(counts);
  add_to_digest(work);

  const Walked walked = add_walks(names, a, b, pose);
  if (walked.visits > 1) {
    const uint32_t start = measure(names.part("start"), [&] {
      PairQuery begun(a, b, pose);
      (void)begun.run(1, kEveryPair);
    });
    add_quotient(names.part("leaf_pair"), int64_t{whole} - walked.instructions - start,
                 walked.leaf_pairs);
  }
  return status == Status::done && walked.visits == counts.visits &&
         walked.leaf_pairs == counts.leaf_pairs;
}

void add_triangle_tests(const char* set, const Mesh& a, const Mesh& b, const Pose& pose) {
  const Transform transform(pose, a, b, /*may_stop=*/false);
  (void)walk_pose<LeafPlanes<Mesh>>(a, b, pose, [&](uint32_t i, uint32_t j) {
    const uint32_t leaf_a = a.nodes[i].leaf();
    const uint32_t leaf_b = b.nodes[j].leaf();
    for (uint32_t of_b = b.first_triangle(leaf_b); of_b < b.end_triangle(leaf_b); ++of_b) {
      Triangle triangle_b;
      transform_triangle(b, of_b, transform, triangle_b);
      for (uint32_t of_a = a.first_triangle(leaf_a); of_a < a.end_triangle(leaf_a); ++of_a) {
        Triangle triangle_a;
        translate_triangle(a, of_a, kNoOffset, triangle_a);
        PlaneNormal normal_b;
        get_near_normal(triangle_b, normal_b);
        measure({{set, "triangle_test"}},
                [&] { (void)near_triangles_intersect(triangle_a, triangle_b, normal_b); });
      }
    }
  });
}

}  // namespace figures
