// Instructions of the parts of a query, counted on the target; on the host all counts of
// instructions are 0.
#ifndef FLASHBVH_TESTS_FIGURES_MEASURE_HPP
#define FLASHBVH_TESTS_FIGURES_MEASURE_HPP

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "report.hpp"

namespace figures {

/// Leaves that reject all that is below them: what is left of a walk is its visits to pairs of
/// nodes that are no leaves, and to the first pair with one.
struct NothingBelow {
  using Tree = flashbvh::PostMesh;
  static constexpr bool kShapes = true;
  static constexpr bool kKnowsRoot = false;
  const flashbvh::PostMesh& a;
  const flashbvh::PostMesh& b;

  NothingBelow(const flashbvh::PostMesh& mesh_a, const flashbvh::PostMesh& mesh_b,
               const flashbvh::detail::Transform&)
      : a(mesh_a), b(mesh_b) {}
  template <class Bound>
  static void set_bound(const Bound&) {}
  static bool is_taken(flashbvh::detail::Side, uint32_t) { return false; }
  static void take_again(flashbvh::detail::Side, uint32_t) {}
  static uint32_t work_of(flashbvh::detail::Side, uint32_t) { return 0; }
  static bool begin(flashbvh::detail::Side, uint32_t, const flashbvh::detail::PackedBox*) {
    return false;
  }
  static bool may_touch(const flashbvh::detail::PackedBox&) { return false; }
};

struct Walked {
  uint32_t visits;
  uint32_t leaf_pairs;
  uint32_t instructions;
  uint32_t inner_visits;  ///< outside the leaf phase: no leaf, or the first pair with one
  uint32_t inner_instructions;
  uint32_t slabs;  ///< made, their leaves taken
  uint32_t slab_instructions;
};

/// The walk alone: from the first visit to the last, slabs made, the preparation left out and pairs
/// of leaves counted; once more as if nothing below a leaf mattered, and once with slabs made
/// twice.
Walked measure_walk(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                    const flashbvh::Pose& pose);

struct Queried {
  flashbvh::Status status;
  flashbvh::Counts counts;
  uint32_t work;
  uint32_t instructions;  ///< made and run to its end, all pairs found
  uint32_t until_first;   ///< made and run to the first pair, or to its end
  uint32_t start;         ///< made and run for one visit
};

Queried measure_query(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                      const flashbvh::Pose& pose);

/// Adds the exact test, without transforming, of each pair of triangles that the query comes to.
void add_triangle_tests(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                        const flashbvh::Pose& pose, Spread& tests);

/// What the walks and queries under one kind of motion took.
class Motion {
 public:
  /// A walk of fewer visits says little about one.
  static constexpr uint32_t kFewVisits = 100;

  /// Of the same pose.
  void add(const Walked& walked, const Queried& queried);
  /// SET.visit.MOTION: a visit outside the leaf phase, on average and in the worst walk observed;
  /// SET.leaf_visit.MOTION: one in it, slabs and all; SET.slab.MOTION: a slab, and taking the leaf;
  /// SET.bare_visit.MOTION: a visit in the leaf phase without; SET.start.MOTION: a query made and
  /// its first visit; SET.leaf_pair.MOTION: what a pair of leaves adds to a query.
  void print(const char* set, const char* motion) const;

 private:
  uint64_t visits_ = 0;
  uint64_t leaf_pairs_ = 0;
  uint64_t walks_ = 0;  ///< instructions
  uint64_t inner_visits_ = 0;
  uint64_t inner_walks_ = 0;
  uint64_t slabs_ = 0;
  uint64_t making_ = 0;
  uint64_t queries_ = 0;
  uint64_t worst_walk_ = 0;
  uint64_t worst_visits_ = 0;
  Spread start_;
};

}  // namespace figures

#endif
