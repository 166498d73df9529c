// The same, and a pose made of integers, composed and inverted: what a moving robot needs.
#include "flashbvh/query.hpp"

extern "C" uint32_t entry(const flashbvh::PostTree& a, const flashbvh::PostTree& b,
                          const int32_t (&rotation)[3][3], const int32_t (&cells)[3],
                          flashbvh::PairQuery::Pair* found) {
  const flashbvh::Pose world = flashbvh::Pose::rigid(rotation, cells);
  const flashbvh::Pose pose =
      flashbvh::Pose::relative(world, flashbvh::Pose::translated(cells[2], cells[1], cells[0]));
  flashbvh::PairQuery query(a, b, pose);
  return query.run(100, found, 8).count;
}
