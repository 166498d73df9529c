// The predicate of distance: the nearest triangles.
//
// The nearest pair so far gives a direction, from its point on A to its point on B. Most other
// boxes, leaves and triangles are farther apart along it. They are rejected by their numbers in
// flash, before anything is rotated.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/bounds/gap.hpp"
#include "flashbvh/detail/bounds/leaf_gap.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/query/proximity.hpp"
#include "flashbvh/detail/query/triangle_test.hpp"
#include "flashbvh/detail/walk/proximity_planes.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// A run's data of the nearest pair so far, computed from the pair when the run begins.
struct NearestSoFar {
  explicit NearestSoFar(const Transform& where) : transform(where) {
    // Without planes, their numbers are not read.
    // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject)
    if (where.is_far()) {
      along = SupportGap(where);
    }
  }

  const Transform& transform;  ///< prepared
  Direction direction;         ///< of the last separation of two triangles
  Fraction least = kInfinite;  ///< squared distance
  int64_t limit = INT64_MAX;   ///< the largest squared gap that still matters
  SupportPlanes planes;        ///< of the nearest triangles
  SupportGap along;            ///< the direction between the nearest points
  uint16_t turns = 0;          ///< how often both changed
  bool is_short = false;       ///< true if 32 bits suffice to separate triangles by the limit

  /// Sets planes and direction of new nearest triangles, which do not intersect. Kept out of line,
  /// so that its temporaries are in no frame below a test.
  FLASHBVH_NOINLINE void turn(const Triangle& a, const Triangle& b, const Features& features) {
    planes = SupportPlanes(a, b, features);
    ++turns;
    if (transform.is_far()) {
      planes.widen();
      along = SupportGap(planes.direction(), transform, limit);
      is_short = limit < ProximityPredicate::kMostFarLimit;
    } else {
      along = SupportGap(LeafGap(planes.direction(), transform, limit));
      is_short = true;
    }
  }
};

template <class Index>
struct Nearest;

/// A walk's box test: along the direction first, which is cheapest.
template <class Index>
class NearestGap {
 public:
  FLASHBVH_NOINLINE NearestGap(const Transform& transform, const Nearest<Index>& nearest)
      : nearest_(&nearest),
        kept_(transform, GapLimit(nearest.so_far->limit)),
        is_kept_(KeptGap::is_for(transform, kept_.limit())) {
    if (!is_kept_) {
      const GapLimit limit = kept_.limit();
      translated_ = TranslatedGap(transform.translated().offset, limit);
    }
  }

  FLASHBVH_INLINE bool operator()(const PackedBox& a, const PackedBox& b) {
    return !nearest_->so_far->along.separates(a, b) && (is_kept_ ? kept_(a, b) : translated_(a, b));
  }
  const Nearest<Index>& nearest() const { return *nearest_; }
  /// Calls `set` with the box test that follows the direction's.
  template <class Set>
  FLASHBVH_INLINE void give(const Set& set) {
    is_kept_ ? set(kept_) : set(translated_);
  }

 private:
  const Nearest<Index>* nearest_;
  union {
    KeptGap kept_;
    TranslatedGap translated_;
  };
  bool is_kept_;
};

/// Leaf planes that first test the end of the leaf's triangles along the direction.
template <class Mesh>
class NearestPlanes : public ProximityPlanes<Mesh> {
  using Base = ProximityPlanes<Mesh>;

 public:
  static constexpr bool kComparesLeaves = true;
  using Base::Base;

  void set_box_test(NearestGap<typename Mesh::Index>& bound) {
    nearest_ = &bound.nearest();
    if (turns_ == nearest_->so_far->turns) {  // nor did the limit change
      bound.give([&](auto& beyond) { this->keep_box_test(beyond); });
      return;
    }
    turns_ = nearest_->so_far->turns;
    bound.give([&](auto& beyond) { this->Base::set_box_test(beyond); });
    if (this->leaf_side() != Side::none) {
      take_end(this->leaf_side(), this->leaf());
    }
  }
  /// A leaf that the direction rejects is not made current: nothing is tested below it.
  FLASHBVH_INLINE bool begin(Side side, uint32_t node, const PackedBox* reached) {
    take_end(side, (side == Side::a ? this->a : this->b).nodes[node].leaf());
    if (reached != nullptr && !may_reach(*reached)) {
      return false;
    }
    this->take(side, node);
    return true;
  }
  FLASHBVH_INLINE bool may_touch(const PackedBox& box) {
    return may_reach(box) && this->may_touch_late(box);
  }
  /// True if the triangles of the other tree's leaf at `node` are too far off: along the direction
  /// or the leaf's own axes, or because both leaves have only ties.
  FLASHBVH_NOINLINE bool rejects_leaf(uint32_t node, Progress& /*progress*/) {
    const Side other = this->leaf_side() == Side::a ? Side::b : Side::a;
    const auto& reached = (other == Side::a ? this->a : this->b).nodes[node];
    const int32_t end = along().end_of(other == Side::a ? this->a : this->b, other, reached.leaf());
    return end <= most_ ||
           (end <= most_ + SupportGap::kTie && has_ties_alone() && ties_alone(other, reached)) ||
           !this->may_touch_along_own_axes(reached.box);
  }

 private:
  using Node = flashbvh::Node<typename Mesh::Index>;

  const SupportGap& along() const { return nearest_->so_far->along; }
  /// ties_alone() of the current leaf, cached.
  bool has_ties_alone() {
    if (ties_ == Ties::unknown) {
      ties_ = ties_alone(this->leaf_side(), *this->node_) ? Ties::alone : Ties::not_alone;
    }
    return ties_ == Ties::alone;
  }
  bool ties_alone(Side side, const Node& node) const {
    return nearest_->ties_alone(side == Side::a ? this->a : this->b, side, node);
  }
  FLASHBVH_NOINLINE void take_end(Side side, uint32_t leaf) {
    const SupportGap& gap = along();
    ties_ = Ties::unknown;
    row_ = &gap.row_beside(side);
    most_ = gap.most_beside(gap.end_of(side == Side::a ? this->a : this->b, side, leaf));
  }
  FLASHBVH_INLINE bool may_reach(const PackedBox& box) const {
    return SupportGap::end_along(*row_, box) > most_;
  }

  enum class Ties : uint8_t { unknown, alone, not_alone } ties_ = Ties::unknown;
  uint16_t turns_ = 0;
  const Nearest<typename Mesh::Index>* nearest_ = nullptr;
  const SplitRow* row_ = nullptr;
  int32_t most_ = SupportGap::kNothing;
};

/// Triangles that may be nearer than all triangles tested before. The caller measures them exactly
/// by take(), after the frames of the test are gone.
///
/// `allowance`, in 2^-16: the share of the least distance by which the result may exceed it.
template <class Index>
struct Nearest : ProximityPredicate {
  template <class Mesh>
  using Shapes = NearestPlanes<Mesh>;
  static constexpr bool kAlwaysKeepsBound = true;
  static constexpr uint32_t kBatch = 1;
  static constexpr uint32_t kPairWork = kTrianglePairWork;
  static constexpr uint32_t kExpensiveWork = 0;
  static constexpr bool kKeepsShapes = true;
  /// A first, coarse walk passes over pairs that are not 2^kCoarse times nearer, squared.
  static constexpr uint32_t kCoarse = 3;

  uint32_t tested = 0;  ///< pairs of triangles
  union {
    uint32_t beyond = 0;   ///< between runs: the most by which B was put nearer, in 1/256 cell
    NearestSoFar* so_far;  ///< during a run: its data
  };
  Index nearest_a = 0;  ///< slots of the nearest triangles so far
  Index nearest_b = 0;
  uint16_t allowance = 0;
  bool is_coarse : 1;     ///< true in a first walk, which finds a pair near the nearest one
  bool has_nearest : 1;   ///< true if there is a nearest pair
  bool intersect : 1;     ///< true if it intersects
  bool has_features : 1;  ///< true if its nearest features are known
  uint8_t of_a : 2;
  uint8_t of_b : 2;
  FeatureKind kind;

  Nearest()
      : is_coarse(false),
        has_nearest(false),
        intersect(false),
        has_features(false),
        of_a(0),
        of_b(0),
        kind(FeatureKind::intersection) {}

  Features features() const { return {kind, of_a, of_b}; }

  NearestGap<Index> kept(const Transform& transform) const { return {transform, *this}; }

  template <class Mesh>
  Status error_of(const Transform&, const Mesh&, const Mesh&) const {
    return Status::done;
  }

  /// SupportGap::ties_alone() of a leaf with the nearest triangles; false while there are none.
  template <class Mesh>
  FLASHBVH_NOINLINE bool ties_alone(const Mesh& mesh, Side side, const Node<Index>& node) const {
    const auto& nearest = mesh.triangles[side == Side::a ? nearest_a : nearest_b];
    return has_nearest && so_far->along.ties_alone(mesh, side, node, nearest.corner);
  }

  /// False only if two triangles are not nearer. `may_tie`: true if they may be exactly as far
  /// apart as the nearest pair.
  FLASHBVH_NOINLINE bool test(const Triangle& a, const Triangle& b, uint32_t /*i*/, uint32_t /*j*/,
                              bool may_tie = true) const {
    const int64_t limit = so_far->limit;
    return !((may_tie && so_far->planes.separates(a, b)) || squared_box_gap(a, b) > limit ||
             (so_far->is_short && (directions_separate(a, b, limit, so_far->direction) ||
                                   planes_separate(a, b, limit))));
  }
  /// The largest squared gap that matters beside a squared distance.
  int64_t limit_of(const Fraction& squared) const {
    return largest_below(squared, allowance) >> (is_coarse ? kCoarse : 0);
  }
  /// True if they are nearer; they become the nearest pair, and the caller sets their slots.
  bool take(const Triangle& a, const Triangle& b) {
    Features features;
    if (!is_nearer(a, b, so_far->least, features)) {
      return false;
    }
    keep(a, b, features);
    return true;
  }

 private:
  /// Kept out of line, so that fewer registers are saved above a search.
  FLASHBVH_NOINLINE void keep(const Triangle& a, const Triangle& b, const Features& features) {
    has_nearest = true;
    intersect = features.kind == FeatureKind::intersection;
    has_features = true;
    of_a = features.of_a & 3;
    of_b = features.of_b & 3;
    kind = features.kind;
    so_far->limit = limit_of(so_far->least);
    if (!intersect) {
      so_far->turn(a, b, features);
    }
  }
};

/// Places only triangles that the direction does not separate.
template <class Index, class Mesh>
class TriangleTest<Nearest<Index>, Mesh, false> {
 public:
  TriangleTest(Nearest<Index>& predicate, const Mesh& a, const Mesh& b, const Transform& transform)
      : predicate_(predicate), a_(a), b_(b), transform_(transform) {}

  bool take_b(uint32_t of_b, const PackedBox* /*box_a*/) {
    if (kept_.take(of_b)) {
      end_ = predicate_.so_far->along.end_of_triangle(b_, Side::b, of_b);
    }
    return true;
  }
  FLASHBVH_INLINE bool operator()(uint32_t of_a) {
    const SupportGap& along = predicate_.so_far->along;
    ++predicate_.tested;
    const int32_t end = along.end_of_triangle(a_, Side::a, of_a);
    if (along.separates(end, end_)) {
      return false;
    }
    const Triangle& b = kept_.placed(b_, transform_);
    Triangle a;
    translate_triangle(a_, of_a, kNoOffset, a);
    return predicate_.test(a, b, of_a, kept_.position(), along.nearly_separates(end, end_));
  }

 private:
  Nearest<Index>& predicate_;
  const Mesh& a_;
  const Mesh& b_;
  const Transform& transform_;
  KeptTriangle<Mesh> kept_;
  int32_t end_ = 0;  ///< of B's triangle, along the direction
};

}  // namespace flashbvh::detail

#pragma GCC diagnostic pop
