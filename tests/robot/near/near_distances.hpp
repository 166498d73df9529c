// Distances of links, by queries only if boxes and the pair's last query do not decide.
//
// In doubles, with nothing that the guard uses. Seen from A, the corner of B's box that moves
// farthest bounds the travel of all its points: the difference of two placements is affine.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "support/arms/placed_links.hpp"

namespace flashbvh::test {

/// More than any distance, and little enough for sums.
constexpr std::int64_t kUnbounded = INT64_MAX / 4;

/// Inclusive bounds of the `lower` that a query would report, in 1/256 cell.
struct NearBounds {
  std::int64_t lower = 0;
  std::int64_t upper = kUnbounded;
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
  struct Box3 {
    Vector3 low;
    Vector3 high;
  };
  struct Measured {
    bool is_known = false;
    Transform at;  ///< in cells
    std::int64_t lower;
    std::int64_t upper;
    Witness<std::uint16_t> hint;
  };

  static Box3 box_of(const Mesh& mesh);
  static double moved(const Box3& box, const Transform& from, const Transform& to);
  static double gap(const Box3& a, const Box3& b, const Transform& b_in_a);

  const Robot& robot_;
  std::vector<Box3> boxes_;
  std::vector<Measured> measured_;
  long queries_ = 0;
};

}  // namespace flashbvh::test
