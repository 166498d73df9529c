// Tests whether two bodies are within a distance, with the last nearest triangles as a hint.
#pragma once

#include <stdint.h>

#include "flashbvh/clearance.hpp"

namespace flashbvh::detail {

/// Predicate for triangles that may be nearer than a fixed limit. As the limit is fixed, leaves are
/// batched.
template <class Index>
struct NearAt : Nearest<Index> {
  static constexpr uint32_t kBatch = 4;
};

template <class Index, class Mesh>
class TriangleTest<NearAt<Index>, Mesh, false> : public TriangleTest<Nearest<Index>, Mesh, false> {
 public:
  TriangleTest(NearAt<Index>& predicate, const Mesh& a, const Mesh& b, const Transform& transform)
      : TriangleTest<Nearest<Index>, Mesh, false>(predicate, a, b, transform) {}
};

/// Passes each pair of triangles that may be within a distance to a sink. It is a nearest search
/// whose limit is known from the start. The direction between the hint's triangles rejects most
/// boxes and leaves before anything is rotated.
template <class MeshType>
class NearQuery : protected Query<Ranked<MeshType>, NearAt<typename MeshType::Index>> {
  using Base = Query<Ranked<MeshType>, NearAt<typename MeshType::Index>>;

 public:
  using Index = typename MeshType::Index;

  /// `distance`: in 1/256 cell, at most Within::kMostShort. `direction`: between the hint's
  /// triangles, from A's to B's; or zero.
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

  /// Returns whether the sink's current pair is within the distance. Which pairs beyond it are
  /// passed depends on where a run began. Not inlined: keeps this frame out of the walk's stack.
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
    known.turns = 1;  // differs from the leaf planes' count, so that they take the limit
    turn(known);
    this->so_far = &known;
    const Status status = this->run_with(
        work, [&sink](const TrianglePair<Index>& pair) { return give(sink, pair); },
        [] { return UINT32_MAX; });
    this->beyond = 0;
    return status;
  }
  /// The largest squared gap, in square cells, that is not rejected.
  int64_t limit() const {
    return static_cast<int64_t>(uint64_t{distance_} * distance_ / Within::kStepsSquared);
  }
  template <class Sink>
  FLASHBVH_NOINLINE static bool give(const Sink& sink, const TrianglePair<Index>& pair) {
    return sink(pair);
  }
  /// Not inlined: keeps this frame out of the walk's stack.
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
