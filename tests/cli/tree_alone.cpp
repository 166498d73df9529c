// Links one image of several.
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "ring.fbvh.h"

int main() {
  const flashbvh::Pose pose = flashbvh::Pose::translated(1, 2, 3);
  const auto ring = flashbvh::view_unchecked<flashbvh::Mesh>(ring_image);
  flashbvh::PairQuery query(ring, ring, pose);
  flashbvh::TrianglePair<uint16_t> found[4];
  return query.run(100000, found).status == flashbvh::Status::full ? 0 : 1;
}
