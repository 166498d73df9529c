// Links `tree` and not `levelled_mesh`.
#include "flashbvh/query.hpp"
#include "ring.fbvh.hpp"

int main() {
  const flashbvh::Pose pose = flashbvh::Pose::translated(1, 2, 3);
  flashbvh::PairQuery query(ring::mesh, ring::mesh, pose);
  flashbvh::TrianglePair<uint16_t> found[4];
  return query.run(100000, found).status == flashbvh::Status::full ? 0 : 1;
}
