// Poses of a given proximity, equal on every machine. For the host: it searches until it finds one.
#pragma once

#include <cstdint>

#include "query_pose.hpp"
#include "support/random.hpp"

namespace figures {

/// Two meshes, which must outlive their users.
struct Meshes {
  const flashbvh::Mesh* a;
  const flashbvh::Mesh* b;
};

/// B is rotated at random, or not at all, and approaches A from any direction, the middles of their
/// boxes aligned, until they touch. From there it is translated on or back by a part of its size.
class PoseSearch {
 public:
  /// Poses are found with one pair of trees, counts with the other, over equal meshes.
  PoseSearch(const Meshes& searched, const Meshes& queried, std::uint64_t seed);

  QueryPose next(Proximity proximity, bool rotated);

 private:
  struct Approach {
    QueryPose rotated;  ///< at the origin; the counts are 0
    std::int64_t direction[3];
  };

  Approach any_approach(bool rotated);
  /// B's middle at a distance, in cells, from A's; the counts are 0.
  QueryPose at(const Approach& approach, std::int64_t distance) const;
  bool touches(const Approach& approach, std::int64_t distance) const;
  /// The largest distance at which the boxes touch; -1 if there is none.
  std::int64_t touching_distance(const Approach& approach) const;
  /// The translation of B away from contact; negative: towards A.
  std::int64_t gap_of(Proximity proximity);
  /// Fills in the counts.
  bool is(Proximity proximity, QueryPose& query_pose) const;

  Meshes searched_;
  Meshes queried_;
  flashbvh::test::Random random_;
  std::int64_t middle_a_[3];  ///< in half cells
  std::int64_t middle_b_[3];
  std::int64_t reach_;   ///< at this distance their boxes are disjoint in any rotation of B
  std::int64_t size_b_;  ///< the longest side of B's box
};

}  // namespace figures
