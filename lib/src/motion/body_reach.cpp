// Bounds on the motion of a body's points, from levers, turns and travel.
#include "flashbvh/detail/motion/body_reach.hpp"

#include "../lattice/fixed_point.hpp"
#include "../lattice/vertex_rounding.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "moved_frame.hpp"

namespace flashbvh::detail {
namespace {

/// Bound on origins, exclusive, in cells.
constexpr uint32_t kFarthestOrigin = 1u << 18;

/// Bound on the arcs of a point, in 2^-31 cell by turn: 2^23 cells times a turn, a path below 2^26
/// cells. So the shortest interval, 2^-29 of a motion, moves no point by a quarter of a cell.
constexpr uint64_t kLongestPath = uint64_t{1} << 54;

/// A part of a move's travel, and of the arc of a point at distance `lever` from the axis; in
/// 1/2,048 cell, rounded up.
uint64_t part_of(uint32_t length, uint32_t part) {
  return (uint64_t{length} * part >> 30) + 1;
}
uint64_t arc_of(const Move& move, uint32_t part, uint64_t lever) {
  // 2 pi in 2^-8, rounded up; `turned` is in 2^-28 turn.
  constexpr uint32_t full_turn = 1609;
  const uint64_t turned = part_of(magnitude(move.turn), part);
  return ((turned * lever >> 20) * full_turn >> 16) + 1;
}

/// Upper bound on the distance between a point's end by the moves and by the motion's last pose, in
/// 1/256 cell. `farthest`: the point's largest coordinates in B's frame, in 1/2,048 cell.
uint32_t end_error(const BodyMotion& motion, const uint64_t (&farthest)[3]) {
  const Frame end = frame_at(motion, kMotionEnd);
  const Frame to = frame_of(motion.to());
  uint64_t most = 0;
  for (int i = 0; i < 3; ++i) {
    uint64_t off = magnitude(end.translation[i] - to.translation[i]) + 1;
    for (int j = 0; j < 3; ++j) {
      off += (magnitude(end.rotation[i][j] - to.rotation[i][j]) * farthest[j] >> 30) + 1;
    }
    most = off > most ? off : most;
  }
  return static_cast<uint32_t>(most * 222 >> 10) + 1;  // sqrt(3) / 8
}

}  // namespace

bool BodyReach::set(const BodyMotion& motion, const PackedBox& packed, const int32_t (&origin_a)[3],
                    const int32_t (&origin_b)[3]) {
  const Box box = unpack(packed);
  const int32_t lower[3] = {box.lower.x, box.lower.y, box.lower.z};
  const int32_t upper[3] = {box.upper.x, box.upper.y, box.upper.z};
  uint64_t diagonal = 0;
  uint64_t from_origin = 0;
  uint64_t extent[3];
  for (int i = 0; i < 3; ++i) {
    if ((magnitude(origin_a[i]) | magnitude(origin_b[i])) >= kFarthestOrigin) {
      return false;
    }
    centre_[i] = (2 * origin_b[i] + lower[i] + upper[i]) * (kFrameCell / 2);
    const auto width = static_cast<uint64_t>(upper[i] - lower[i]);
    diagonal += width * width;
    extent[i] = magnitude(centre_[i]) + width * (kFrameCell / 2);
    from_origin += magnitude(origin_b[i]);
  }
  radius_ = square_root(diagonal << 20) + 1;  // half the diagonal
  const uint64_t most = farthest(motion, uint64_t{length_of(frame_of(motion.from()).translation)} +
                                             length_of(centre_) + radius_);
  if (most > kMaxFrameTranslation) {
    return false;
  }
  uint64_t turned = 0;  // in 2^-20 turn
  for (uint32_t i = 0; i < motion.move_count(); ++i) {
    turned += magnitude(motion.move(i).turn) >> 8;
  }
  if (turned * most > kLongestPath) {
    return false;
  }
  rounding_ = kVertexRounding + static_cast<uint32_t>(from_origin * 443 >> 23) + 1;
  path_error_ =
      motion.move_count() * (static_cast<uint32_t>(most >> 27) + 1) + end_error(motion, extent);
  way_ = 0;
  if (motion.move_count() == 1) {  // its lever is constant
    const uint64_t way = moved_by(motion.move(0), kMotionEnd, frame_of(motion.from()), 0);
    way_ = way <= UINT32_MAX ? static_cast<uint32_t>(way) : 0;
  }
  return true;
}

/// How far a part of a move moves points of B, in 1/2,048 cell. `frame`: B's after the inner moves,
/// which may move a point by up to `inside` more.
uint64_t BodyReach::moved_by(const Move& move, uint32_t part, const Frame& frame,
                             uint64_t inside) const {
  const uint64_t travelled = part_of(length_of(move.travel), part);
  if (move.turn == 0) {
    return travelled;
  }
  const uint64_t lever = distance_from_axis(move, place(frame, centre_)) + radius_ + inside;
  return travelled + arc_of(move, part, lever);
}

uint64_t BodyReach::around(const BodyMotion& motion, uint32_t middle, uint32_t half,
                           Frame& frame) const {
  uint64_t moved = way_ == 0 ? 0 : part_of(way_, half);
  frame = frame_of(motion.from());
  for (uint32_t i = motion.move_count(); i-- > 0;) {
    const Move& move = motion.move(i);
    moved += way_ == 0 ? moved_by(move, half, frame, moved) : 0;
    carry(move, middle, frame);
  }
  return (moved >> 3) + 1;
}

}  // namespace flashbvh::detail
