// Distances of links, by queries only if boxes and the pair's last query do not decide.
//
// In doubles, with nothing that the guard uses. Seen from A, the corner of B's box that moves
// farthest bounds the travel of all its points: the difference of two placements is affine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::test {

/// Inclusive bounds of the `lower` that a query would report, in 1/256 cell.
struct NearBounds {
  std::int64_t lower = 0;
  std::int64_t upper = INT64_MAX;
};

/// The distances of one robot's pairs; remembers the last query of each.
class NearOracle {
 public:
  explicit NearOracle(const Robot& robot);

  /// Bounds without a query.
  NearBounds bounds(std::uint32_t pair, const Pose& pose) const;
  /// Bounds by a query: both are its `lower`.
  NearBounds measured(std::uint32_t pair, const Pose& pose);
  /// The number of queries so far.
  long queries() const { return queries_; }

 private:
  using Point3 = std::array<double, 3>;
  struct Box3 {
    Point3 low;
    Point3 high;
  };
  /// Three rows of a rotation and a translation, in cells.
  using Placement = std::array<std::array<double, 4>, 3>;
  struct Measured {
    bool is_known = false;
    Placement at;
    std::int64_t lower;
    std::int64_t upper;
    Witness<std::uint16_t> hint;
  };

  static Placement placement_of(const Pose& pose);
  static Box3 box_of(const Mesh& mesh);
  static double moved(const Box3& box, const Placement& from, const Placement& to);
  static double gap(const Box3& a, const Box3& b, const Placement& b_in_a);

  const Robot& robot_;
  std::vector<Box3> boxes_;
  std::vector<Measured> measured_;
  long queries_ = 0;
};

}  // namespace flashbvh::test
