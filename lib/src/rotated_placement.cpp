// Preparing a rotated placement, and placing vertices.
#include "flashbvh/rotated_placement.hpp"

namespace flashbvh {
namespace {

constexpr unsigned kRestBits = 8;
constexpr int32_t kHalf = kSplitOne / 2;

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
  constexpr int64_t most = static_cast<int64_t>(kMaxOffset) * kSplitOne;
  return static_cast<int32_t>(offset > most ? most : offset < -most ? -most : offset);
}

/// Where B's origin lies in A's lattice: `offset`, kSplitOne is a cell.
void offset_of(const Pose& pose, const int32_t (&origin_a)[3], const int32_t (&origin_b)[3],
               int32_t (&offset)[3]) {
  for (int i = 0; i < 3; ++i) {
    // Wraps if the pose is out of range, which is an error of the pose.
    const auto cells = static_cast<int32_t>(static_cast<uint32_t>(pose.translation(i)) -
                                            static_cast<uint32_t>(origin_a[i]));
    // 30 fraction bits; below 2^62.
    int64_t sum = static_cast<int64_t>(cells) * kRotationOne +
                  static_cast<int64_t>(pose.fraction(i)) * (kRotationOne >> 16);
    for (int j = 0; j < 3; ++j) {
      sum += static_cast<int64_t>(pose.rotation(i, j)) * origin_b[j];
    }
    offset[i] = clamp_offset((sum + (1 << 15)) >> 16);
  }
}

/// Whether an interval of half-width `radius` round `centre` is apart from [-lower, upper].
bool apart(int32_t centre, int32_t radius, uint32_t upper, uint32_t lower) {
  const int32_t cells = centre >> kSplitBits;
  return cells - radius > static_cast<int32_t>(upper) - kBoundBias ||
         cells + radius < kBoundBias - static_cast<int32_t>(lower);
}

bool far_apart(const int32_t (&offset)[3], const PackedBox& root_a, int32_t reach_b) {
  // A vertex is at most this far from the offset: stretched by the rotation's defect, and rounded.
  const int32_t radius = reach_b + (reach_b >> 12) + 2;
  return apart(offset[0], radius, low_half(root_a.upper_xy), low_half(root_a.lower_xy)) ||
         apart(offset[1], radius, high_half(root_a.upper_xy), high_half(root_a.lower_xy)) ||
         apart(offset[2], radius, low_half(root_a.z), high_half(root_a.z));
}

/// What the rotation of boxes can lack of that of the vertices of B.
int32_t box_margin(const Pose& pose, int32_t reach_b) {
  int32_t most = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int32_t rest = pose.rest(i, j);
      const int32_t size = rest < 0 ? -rest : rest;
      most = size > most ? size : most;
    }
  }
  return ((most * reach_b) >> kRestBits) + 1;
}

/// How far, along one of B's axes, a placed vertex can be from where it lies in B; see
/// lib/docs/design.md, Rotation.
int32_t axis_margin(const Pose& pose, int32_t reach_b) {
  const uint32_t stretched = static_cast<uint32_t>(reach_b) * pose.defect();
  return 7 * (kSplitOne / 8) + ((7 * reach_b) >> 3) + static_cast<int32_t>(stretched >> 10) + 4;
}

/// Products are of biased bounds and make a biased bound.
BoundStart start_of(const SplitRow& row, int32_t offset, int32_t margin) {
  const int32_t bias = (kSplitOne - row.sum()) * kBoundBias;
  return {bias + margin + offset, bias + margin - offset};
}

constexpr int32_t Point::*kAxes[3] = {&Point::x, &Point::y, &Point::z};

/// What makes one coordinate of a placed vertex.
class Row {
 public:
  Row(const RotatedPlacement& placement, int axis) {
    const SplitRow& row = placement.pose->rows().row[axis];
    x_ = row.x();
    y_ = row.y();
    z_ = row.z_entry();
    rest_x_ = placement.pose->rest(axis, 0);
    rest_y_ = placement.pose->rest(axis, 1);
    rest_z_ = placement.pose->rest(axis, 2);
    const BoundStart& start = placement.on_a[axis];
    offset_ = (start.upper - start.lower) / 2 + kHalf;  // exact: see start_of()
  }

  int32_t place(const Vertex& v) const {
    const int32_t rest = rest_x_ * v.x + rest_y_ * v.y + rest_z_ * v.z;
    return (x_ * v.x + y_ * v.y + z_ * v.z + (rest >> kRestBits) + offset_) >> kSplitBits;
  }

 private:
  int32_t x_, y_, z_;
  int32_t rest_x_, rest_y_, rest_z_;
  int32_t offset_;
};

}  // namespace

bool RotatedPlacement::prepare(const Pose& from, const int32_t (&origin_a)[3],
                               const PackedBox& root_a, const int32_t (&origin_b)[3],
                               const PackedBox& root_b, bool may_stop) {
  int32_t offset[3];
  offset_of(from, origin_a, origin_b, offset);
  const int32_t reach_b = reach(root_b);
  if (may_stop && far_apart(offset, root_a, reach_b)) {
    return false;
  }
  pose = &from;
  const int32_t box = box_margin(from, reach_b) + kHalf;
  const int32_t axis = axis_margin(from, reach_b);
  for (int i = 0; i < 3; ++i) {
    const SplitRow& column = from.columns().row[i];
    const int64_t back = static_cast<int64_t>(column.x()) * offset[0] +
                         static_cast<int64_t>(column.y()) * offset[1] +
                         static_cast<int64_t>(column.z_entry()) * offset[2];
    on_a[i] = start_of(from.rows().row[i], offset[i], box);
    on_b[i] = start_of(column, clamp_offset(-(back >> kSplitBits)), axis);
  }
  return true;
}

Point RotatedPlacement::place(const Vertex& v) const {
  return {Row(*this, 0).place(v), Row(*this, 1).place(v), Row(*this, 2).place(v)};
}

void RotatedPlacement::place(const Vertex& u, const Vertex& v, const Vertex& w,
                             PlacedTriangle& placed) const {
  for (int axis = 0; axis < 3; ++axis) {
    const Row row(*this, axis);
    const auto coordinate = kAxes[axis];
    placed.corner[0].*coordinate = row.place(u);
    placed.corner[1].*coordinate = row.place(v);
    placed.corner[2].*coordinate = row.place(w);
  }
}

}  // namespace flashbvh
