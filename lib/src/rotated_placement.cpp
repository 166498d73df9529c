// Preparing a rotated placement, and placing vertices.
#include "flashbvh/rotated_placement.hpp"

namespace flashbvh {
namespace {

/// From a pose's 30 fraction bits to the 22 of a vertex's rotation.
constexpr unsigned kDroppedBits = 8;
/// Of these 22, how many the boxes do without.
constexpr unsigned kRestBits = 8;

/// The largest magnitude of a coordinate in the box.
int32_t reach(uint32_t upper, uint32_t lower) {
  return static_cast<int32_t>(upper > lower ? upper : lower) - kBoundBias;
}

/// The sum of the largest magnitudes of x, y and z in the box: no point of it, however turned, has
/// a larger coordinate.
int32_t reach(const PackedBox& box) {
  return reach(low_half(box.upper_xy), low_half(box.lower_xy)) +
         reach(high_half(box.upper_xy), high_half(box.lower_xy)) +
         reach(low_half(box.z), high_half(box.z));
}

int32_t clamp_offset(int64_t offset) {
  constexpr int64_t most = static_cast<int64_t>(kMaxOffset) * kPlacementOne;
  return static_cast<int32_t>(offset > most ? most : offset < -most ? -most : offset);
}

/// Whether an interval of half-width `reach` round `centre` is apart from [-lower, upper].
bool apart(int32_t centre, int32_t reach, uint32_t upper, uint32_t lower) {
  return centre - reach > static_cast<int32_t>(upper) - kBoundBias ||
         centre + reach < kBoundBias - static_cast<int32_t>(lower);
}

}  // namespace

bool RotatedPlacement::prepare(const Pose& pose, const int32_t (&origin_a)[3],
                               const PackedBox& root_a, const int32_t (&origin_b)[3],
                               const PackedBox& root_b) {
  set_offset(pose, origin_a, origin_b);
  const int32_t reach_b = reach(root_b);
  if (far_apart(root_a, reach_b)) {
    return false;
  }
  set_rotation(pose, reach_b);
  return true;
}

void RotatedPlacement::set_offset(const Pose& pose, const int32_t (&origin_a)[3],
                                  const int32_t (&origin_b)[3]) {
  for (int i = 0; i < 3; ++i) {
    // 30 fraction bits; below 2^62.
    int64_t sum = static_cast<int64_t>(pose.translation(i) - origin_a[i]) * kRotationOne +
                  pose.fraction(i) * (kRotationOne >> 16);
    for (int j = 0; j < 3; ++j) {
      sum += static_cast<int64_t>(pose.rotation(i, j)) * origin_b[j];
    }
    offset[i] = clamp_offset((sum + (1 << 15)) >> 16);
  }
}

bool RotatedPlacement::far_apart(const PackedBox& root_a, int32_t reach_b) const {
  // A vertex is at most this far from the offset: stretched by the rotation's defect, and rounded.
  const int32_t radius = reach_b + (reach_b >> 12) + 2;
  const auto centre = [this](int i) { return offset[i] >> kPlacementBits; };
  return apart(centre(0), radius, low_half(root_a.upper_xy), low_half(root_a.lower_xy)) ||
         apart(centre(1), radius, high_half(root_a.upper_xy), high_half(root_a.lower_xy)) ||
         apart(centre(2), radius, low_half(root_a.z), high_half(root_a.z));
}

void RotatedPlacement::set_rotation(const Pose& pose, int32_t reach_b) {
  int32_t most_rest = 0;
  int32_t entry[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int32_t fine = (pose.rotation(i, j) + (1 << (kDroppedBits - 1))) >> kDroppedBits;
      const int32_t coarse = (fine + (1 << (kRestBits - 1))) >> kRestBits;
      const int32_t lacking = fine - coarse * (1 << kRestBits);
      entry[i][j] = coarse;
      rest[i][j] = static_cast<int8_t>(lacking);
      const int32_t size = lacking < 0 ? -lacking : lacking;
      most_rest = size > most_rest ? size : most_rest;
    }
    rotation.xy[i] = join_signed(entry[i][0], entry[i][1]);
  }
  rotation.z01 = join_signed(entry[0][2], entry[1][2]);
  rotation.z2 = join_signed(entry[2][2], 0);

  box_margin = ((most_rest * reach_b) >> kRestBits) + 2;
  axis_margin = 3584 + ((7 * reach_b) >> 5) +
                static_cast<int32_t>((static_cast<uint32_t>(reach_b) * pose.defect()) >> 12) + 8;
}

Point RotatedPlacement::place(const Vertex& v) const {
  const uint32_t xy = join_signed(v.x, v.y);
  const uint32_t z = join_signed(v.z, 0);
  const auto coordinate = [&](int i, int32_t last_product) {
    const int32_t rest_sum = rest[i][0] * v.x + rest[i][1] * v.y + rest[i][2] * v.z;
    const int32_t sum = multiply_pairs(rotation.xy[i], xy) + last_product;
    return (sum + (rest_sum >> kRestBits) + offset[i] + kPlacementOne / 2) >> kPlacementBits;
  };
  return {coordinate(0, add_low_low(0, rotation.z01, z)),
          coordinate(1, add_high_low(0, rotation.z01, z)),
          coordinate(2, add_low_low(0, rotation.z2, z))};
}

}  // namespace flashbvh
