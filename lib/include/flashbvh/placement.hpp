// How a query sees B from A's lattice: moved only, or turned too. Which of the two follows from the
// pose; a translation never pays for the arithmetic of a rotation.
#ifndef FLASHBVH_PLACEMENT_HPP
#define FLASHBVH_PLACEMENT_HPP

#include <stdint.h>

#include "flashbvh/box.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/rotated_placement.hpp"
#include "flashbvh/tree.hpp"
#include "flashbvh/triangle.hpp"
#include "flashbvh/walk.hpp"

namespace flashbvh {

/// B moved by whole cells.
struct TranslatedPlacement {
  Point offset;               ///< from B's lattice to A's; both count from their own origins
  TranslatedOverlap overlap;  ///< set by Placement::prepare()
};

/// 56 bytes.
class Placement {
 public:
  /// All that follows from a pose, unless `may_stop` and the root boxes tell already that nothing
  /// can meet.
  template <class TreeType>
  Placement(const Pose& pose, const TreeType& a, const TreeType& b, bool may_stop)
      : kind_(pose.is_translation() ? Kind::translated : Kind::rotated) {
    if (kind_ == Kind::translated) {
      translated_.offset = {offset(pose, a, b, 0), offset(pose, a, b, 1), offset(pose, a, b, 2)};
    } else if (!rotated_.prepare(pose, a.origin, a.nodes[0].box, b.origin, b.nodes[0].box,
                                 may_stop)) {
      kind_ = Kind::far_apart;
    }
  }

  bool is_rotated() const { return kind_ != Kind::translated; }
  bool is_far_apart() const { return kind_ == Kind::far_apart; }
  const TranslatedPlacement& translated() const { return translated_; }
  const RotatedPlacement& rotated() const { return rotated_; }

  /// Two objects that are nowhere near each other, the commonest query, are told apart before
  /// anything is prepared for a walk.
  template <class TreeType>
  bool roots_apart(const TreeType& a, const TreeType& b) const {
    const Point& t = translated_.offset;
    return kind_ == Kind::translated ? boxes_apart(a.nodes[0].box, b.nodes[0].box, t.x, t.y, t.z)
                                     : kind_ == Kind::far_apart;
  }

  /// Before the first walk.
  void prepare() {
    if (kind_ == Kind::translated) {
      const Point& t = translated_.offset;
      translated_.overlap = TranslatedOverlap(t.x, t.y, t.z);
    }
  }

 private:
  enum class Kind : uint8_t { translated, rotated, far_apart };

  /// Wraps if the pose is out of range, which is an error of the pose.
  template <class TreeType>
  static int32_t offset(const Pose& pose, const TreeType& a, const TreeType& b, int axis) {
    return static_cast<int32_t>(static_cast<uint32_t>(pose.translation(axis)) +
                                static_cast<uint32_t>(b.origin[axis]) -
                                static_cast<uint32_t>(a.origin[axis]));
  }

  union {
    TranslatedPlacement translated_;
    RotatedPlacement rotated_;
  };
  Kind kind_;
};

/// Where A's own triangles are.
inline constexpr Point kNoOffset = {0, 0, 0};

/// A triangle of a tree, by its position, moved by whole cells.
template <class TreeType>
FLASHBVH_NOINLINE void place_translated(const TreeType& tree, uint32_t triangle,
                                        const Point& offset, PlacedTriangle& placed) {
  for (int i = 0; i < 3; ++i) {
    const Vertex& v = tree.vertices[tree.triangles[triangle].corner[i]];
    placed.corner[i] = {v.x + offset.x, v.y + offset.y, v.z + offset.z};
  }
}

/// The same, turned and moved.
template <class TreeType>
FLASHBVH_NOINLINE void place_rotated(const TreeType& tree, uint32_t triangle,
                                     const RotatedPlacement& placement, PlacedTriangle& placed) {
  const auto& corner = tree.triangles[triangle].corner;
  placement.place(tree.vertices[corner[0]], tree.vertices[corner[1]], tree.vertices[corner[2]],
                  placed);
}

}  // namespace flashbvh

#endif
