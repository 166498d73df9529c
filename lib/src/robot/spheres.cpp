#include "spheres.hpp"

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"

namespace flashbvh::detail {
namespace {

/// Fraction bits of a length in 1/256 cell.
constexpr int kFineBits = 8;
constexpr int kDropped = kFrameBits - kFineBits;

}  // namespace

int64_t centre_of(const RobotLink& link, const Frame& frame, int axis) {
  const auto& row = frame.rotation[axis];
  const int64_t turned = static_cast<int64_t>(row[0]) * link.centre[0] +
                         static_cast<int64_t>(row[1]) * link.centre[1] +
                         static_cast<int64_t>(row[2]) * link.centre[2];
  return frame.translation[axis] + ((turned + (kRotationOne >> 1)) >> 30);
}

uint32_t distance_above(const Triangle& a, const Triangle& b) {
  Fraction squared = kInfinite;
  Features features;
  (void)is_nearer(a, b, squared, features);
  // Below 2^40 square cells, in 1/65,536 of one.
  return square_root(static_cast<uint64_t>(rounded_up(squared)) << (2 * kFineBits)) + 1;
}

uint32_t sphere_gap(const RobotLink& a, const Frame& frame_a, const RobotLink& b,
                    const Frame& frame_b) {
  uint64_t square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    // Rounded towards 0 by less than 1/256 cell, after 1/2,048 cell for the error of the centres.
    const int64_t apart = centre_of(b, frame_b, axis) - centre_of(a, frame_a, axis);
    const int64_t size = (apart < 0 ? -apart : apart) - 1;
    const uint64_t fine = size < 0 ? 0 : static_cast<uint64_t>(size) >> kDropped;
    square += fine * fine;
  }
  constexpr uint32_t up = (1u << kDropped) - 1;
  const uint32_t radii = ((a.radius + up) >> kDropped) + ((b.radius + up) >> kDropped);
  const uint32_t between = square_root(square);
  return between > radii ? between - radii : 0;
}

}  // namespace flashbvh::detail
