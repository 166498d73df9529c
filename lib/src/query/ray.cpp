// Ray queries, and the walk of a segment through a mesh's tree.
#include "flashbvh/ray.hpp"

#include "../lattice/mesh_frame.hpp"
#include "../predicates/fine_crossing.hpp"
#include "../predicates/segment_hit.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"

namespace flashbvh {
namespace detail {
namespace {

/// Returns the segment relative to the mesh's origin, and sets `status`.
template <class MeshType>
Segment segment_from_origin(const MeshType& mesh, const Segment& segment, Status& status) {
  Segment moved = {};
  const bool fits = get_from_origin(mesh.origin, segment.from, kMaxRayCoordinate, moved.from) &&
                    get_from_origin(mesh.origin, segment.to, kMaxRayCoordinate, moved.to);
  status = !is_usable(mesh) ? cell_error(mesh) : fits ? Status::done : Status::ray_out_of_range;
  return moved;
}

template <class Index>
bool is_before(const RayHit<Index>& x, const RayHit<Index>& y) {
  const int order = order_along(x.along, y.along);
  return order < 0 || (order == 0 && x.triangle < y.triangle);
}

}  // namespace

template <class MeshType>
SegmentWalk<MeshType>::SegmentWalk(const MeshType& mesh, const Segment& segment) noexcept
    : mesh_(&mesh),
      segment_(segment_from_origin(mesh, segment, status_)),
      boxes_(segment_),
      at_(mesh, 0, 0),
      is_over_(status_ != Status::done) {}

template <class MeshType>
bool SegmentWalk<MeshType>::next_leaf() noexcept {
  while (!is_over_) {
    ++visits_;
    const auto& node = at_.node();
    const bool meets = boxes_.may_meet(node.box);
    if (meets && !node.is_leaf()) {
      at_.descend();
      continue;
    }
    is_over_ = !at_.next();
    if (meets) {
      triangle_ = mesh_->first_triangle(node.leaf());
      end_ = mesh_->end_triangle(node.leaf());
      return true;
    }
  }
  return false;
}

template <class MeshType>
bool SegmentWalk<MeshType>::next_triangle(uint32_t& position) noexcept {
  if (triangle_ == end_ && !next_leaf()) {
    return false;
  }
  position = triangle_++;
  return true;
}

template <class MeshType>
bool SegmentWalk<MeshType>::next(RayHit<Index>& hit) noexcept {
  uint32_t position = 0;
  while (next_triangle(position)) {
    if (get_hit(position, hit)) {
      return true;
    }
  }
  return false;
}

template <class MeshType>
void SegmentWalk<MeshType>::get_triangle(uint32_t position, Triangle& t) const noexcept {
  translate_triangle(*mesh_, position, kNoOffset, t);
}

template <class MeshType>
bool SegmentWalk<MeshType>::get_hit(uint32_t position, RayHit<Index>& hit) const noexcept {
  Triangle t;
  get_triangle(position, t);
  if (!first_meeting(segment_, t, hit.along, hit.side)) {
    return false;
  }
  hit.triangle = mesh_->triangle_ids[position];
  hit.slot = static_cast<Index>(position);
  return true;
}

template class SegmentWalk<Mesh>;
template class SegmentWalk<Mesh32>;

}  // namespace detail

template <class Index>
RayAnswer<Index> nearest_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                             const Segment& segment, Index hint) noexcept {
  detail::SegmentWalk<BasicMesh<Index, Layout::post_indexed>> walk(mesh, segment);
  RayAnswer<Index> answer = {walk.status(), walk.status() != Status::done, {}, 0};
  if (answer.status == Status::done && hint != kNoHint<Index> && hint >= mesh.triangle_count) {
    answer.status = Status::hint_invalid;
    answer.yes = true;
  }
  if (answer.status != Status::done) {
    return answer;
  }
  if (hint != kNoHint<Index> && walk.get_hit(hint, answer.hit)) {
    answer.yes = true;
    walk.shorten(answer.hit.along);
  }
  RayHit<Index> hit;
  while (walk.next(hit)) {
    if (!answer.yes || detail::is_before(hit, answer.hit)) {
      answer.yes = true;
      answer.hit = hit;
      walk.shorten(hit.along);
    }
  }
  answer.visits = walk.visits();
  return answer;
}

template <class Index>
RayAnswer<Index> any_hit(const BasicMesh<Index, Layout::post_indexed>& mesh,
                         const Segment& segment) noexcept {
  detail::SegmentWalk<BasicMesh<Index, Layout::post_indexed>> walk(mesh, segment);
  RayAnswer<Index> answer = {walk.status(), true, {}, 0};
  if (answer.status == Status::done) {
    answer.yes = walk.next(answer.hit);
    answer.visits = walk.visits();
  }
  return answer;
}

template <class Index>
CrossingCount signed_crossings(const BasicMesh<Index, Layout::post_indexed>& mesh,
                               const Segment& segment) noexcept {
  if (!mesh.is_closed) {
    return {detail::has_cell(mesh) ? Status::not_closed : Status::not_open, 0, 0};
  }
  detail::SegmentWalk<BasicMesh<Index, Layout::post_indexed>> walk(mesh, segment);
  const Point& from = walk.segment().from;
  const Point& to = walk.segment().to;
  const detail::Vector way = detail::difference(to, from);
  int32_t outwards = 0;
  uint32_t position = 0;
  while (walk.next_triangle(position)) {
    Triangle t;
    walk.get_triangle(position, t);
    const int side = detail::passage(t, from, way);
    if (side != 0 && detail::side_of_plane(t, from) != detail::side_of_plane(t, to)) {
      outwards += side;
    }
  }
  return {walk.status(), outwards, walk.visits()};
}

FinePoint point_along(const Segment& segment, const SegmentShare& along) noexcept {
  FinePoint point;
  detail::set_crossing(segment.from, segment.to, along.above, along.above - along.below, point);
  return point;
}

uint32_t distance_along(const Segment& segment, const SegmentShare& along) noexcept {
  const FinePoint end = point_along(segment, along);
  const int64_t x = end.x - int64_t{segment.from.x} * kFineOne;
  const int64_t y = end.y - int64_t{segment.from.y} * kFineOne;
  const int64_t z = end.z - int64_t{segment.from.z} * kFineOne;
  return static_cast<uint32_t>(detail::square_root(detail::widened(x * x + y * y + z * z)));
}

template RayAnswer<uint16_t> nearest_hit(const Mesh&, const Segment&, uint16_t) noexcept;
template RayAnswer<uint32_t> nearest_hit(const Mesh32&, const Segment&, uint32_t) noexcept;
template RayAnswer<uint16_t> any_hit(const Mesh&, const Segment&) noexcept;
template RayAnswer<uint32_t> any_hit(const Mesh32&, const Segment&) noexcept;
template CrossingCount signed_crossings(const Mesh&, const Segment&) noexcept;
template CrossingCount signed_crossings(const Mesh32&, const Segment&) noexcept;

}  // namespace flashbvh
