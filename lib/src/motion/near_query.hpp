// Whether two bodies are within a distance, from triangles on that were nearest before.
#ifndef FLASHBVH_MOTION_NEAR_QUERY_HPP
#define FLASHBVH_MOTION_NEAR_QUERY_HPP

#include <stdint.h>

#include "flashbvh/clearance.hpp"

namespace flashbvh::detail {

/// Which triangles may be nearer than a limit that does not change: so leaves are batched.
template <class Index>
struct NearAt : Nearest<Index> {
  static constexpr uint32_t kBatch = 4;
};

/// As of the nearest.
template <class Index, class Mesh>
class TriangleTest<NearAt<Index>, Mesh, false> : public TriangleTest<Nearest<Index>, Mesh, false> {
 public:
  TriangleTest(NearAt<Index>& predicate, const Mesh& a, const Mesh& b, const Transform& transform)
      : TriangleTest<Nearest<Index>, Mesh, false>(predicate, a, b, transform) {}
};

/// Hands every pair of triangles that may be within a distance to a sink: as a search for the
/// nearest ones, whose limit is known from the begin on. The direction between the hint's triangles
/// rejects most boxes and leaves before anything is rotated.
template <class MeshType>
class NearQuery : protected Query<Ranked<MeshType>, NearAt<typename MeshType::Index>> {
  using Base = Query<Ranked<MeshType>, NearAt<typename MeshType::Index>>;

 public:
  using Index = typename MeshType::Index;

  /// `distance`: in 1/256 cell, at most Within::kMostShort. `direction`: between triangles that may
  /// be nearest, or zero.
  NearQuery(const MeshType& a, const MeshType& b, const Pose& pose, uint32_t distance,
            const PackedVector& direction)
      : Base(a, b, pose), direction_(direction), distance_(distance) {}

  using Base::cursor;
  using Base::last_slots;
  using Base::resume;
  using Base::stats;

  template <class Sink>
  FLASHBVH_INLINE RunResult run(uint32_t work, const Sink& sink) {
    uint32_t left = work;
    const Status status = run_within(left, sink);
    return {status, 0, work - left};
  }

  /// Whether the pair that the sink has is within the distance: of pairs beyond it, which ones come
  /// depends on where a run began. Apart, so that no walk has its frame above it.
  FLASHBVH_NOINLINE bool is_pair_within() const {
    Triangle a;
    Triangle b;
    this->last_pair(a, b);
    return is_within(a, b, {uint64_t{distance_} * distance_, Within::kStepsSquared});
  }

 private:
  template <class Sink>
  FLASHBVH_NOINLINE Status run_within(uint32_t& work, const Sink& sink) {
    this->prepare();
    NearestSoFar known(this->transform());
    known.limit = limit();
    known.is_short = true;
    known.turns = 1;  // a limit that planes have not yet
    turn(known);
    this->so_far = &known;
    const Status status = this->run_with(
        work, [&sink](const TrianglePair<Index>& pair) { return give(sink, pair); },
        [] { return UINT32_MAX; });
    this->beyond = 0;
    return status;
  }
  /// The largest squared gap, in cells, that matters.
  int64_t limit() const {
    return static_cast<int64_t>(uint64_t{distance_} * distance_ / Within::kStepsSquared);
  }
  template <class Sink>
  FLASHBVH_NOINLINE static bool give(const Sink& sink, const TrianglePair<Index>& pair) {
    return sink(pair);
  }
  /// Apart, so that no walk has its frame above it.
  FLASHBVH_NOINLINE void turn(NearestSoFar& known) const {
    if (direction_.xy == 0 && direction_.z == 0) {
      return;
    }
    known.along = this->transform().is_far()
                      ? SupportGap(direction_, this->transform(), limit())
                      : SupportGap(LeafGap(direction_, this->transform(), limit()));
  }

  PackedVector direction_;
  uint32_t distance_;
};

}  // namespace flashbvh::detail

#endif
