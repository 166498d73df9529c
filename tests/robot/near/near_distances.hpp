// How far apart links are: by distance queries, which are made only where boxes and the last query
// of the pair do not decide.
//
// In doubles and by nothing that a guard uses: seen from A, no point of B's box moves farther than
// the corner that moves farthest, since what the difference of two placements does is affine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::test {

/// Bounds of the `lower` that a query reports, in 1/256 cell, both included.
struct NearBounds {
  std::int64_t lower = 0;
  std::int64_t upper = INT64_MAX;
};

/// Of one robot's pairs; the last query of each is remembered.
class NearOracle {
 public:
  explicit NearOracle(const Robot& robot);

  /// Without a query.
  NearBounds bounds(std::uint32_t pair, const Pose& pose) const;
  /// By a query: both bounds are its `lower`.
  NearBounds measured(std::uint32_t pair, const Pose& pose);
  /// How many there were.
  long queries() const { return queries_; }

 private:
  using Point3 = std::array<double, 3>;
  struct Box3 {
    Point3 low;
    Point3 high;
  };
  /// In cells: three rows of a rotation and a translation.
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
