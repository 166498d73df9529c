#include "reference.h"

#include <flashbvh/flashbvh.hpp>

using namespace flashbvh;

void query_in_cpp(image a, image b, const int32_t rotation[9], const int32_t cells[3],
                  const int16_t fraction[3], answer* to) {
  PostMesh tree_a;
  PostMesh tree_b;
  to->count = 0;
  if (open_image(a.bytes, a.size, tree_a) != Status::done ||
      open_image(b.bytes, b.size, tree_b) != Status::done) {
    to->status = FLASHBVH_STATUS_IMAGE_INVALID;
    return;
  }
  int32_t rows[3][3];
  for (int i = 0; i < 9; ++i) {
    rows[i / 3][i % 3] = rotation[i];
  }
  const Pose pose =
      Pose::rigid(rows, {cells[0], cells[1], cells[2]}, {fraction[0], fraction[1], fraction[2]});
  PairQuery query(tree_a, tree_b, pose);
  const Status status = query.run(UINT32_MAX, [to](const PairQuery::Pair& pair) {
    if (to->count < to->room) {
      to->pairs[to->count] = {pair.a, pair.b};
    }
    ++to->count;
    return true;
  });
  const Counts& counts = query.counts();
  to->counts = {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
  to->status = static_cast<flashbvh_status>(status);
}
