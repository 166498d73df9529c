// The paper's algorithm 4: the pairs of triangles in which an object meets its copy.
#include <flashbvh/query.hpp>
#include <flashbvh/traversal/stackless.hpp>

#include "pre.fbvh.h"
#include "text.hpp"

using namespace flashbvh;

int main() {
  PreMeshWithLevels ring;
  if (open_image(pre_image, sizeof pre_image, ring) != Status::done) {
    return 1;
  }
  const Pose pose = Pose::translated(2000, 500, 300);
  Query<Stackless> query(ring, ring, pose);
  Query<Stackless>::Pair found[16];
  uint32_t count = 0;
  RunResult slice;
  do {
    slice = query.run(1000, found);  // in slices of 1000 work
    count += slice.count;
  } while (slice.status == Status::suspended || slice.status == Status::full);
  port::print(count, " pairs, ", query.stats().visits, " visits\n");
  return slice.status == Status::done ? 0 : 1;
}
