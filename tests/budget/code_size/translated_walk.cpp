// One traversal of boxes, moved and not turned, without triangles.
#include "flashbvh/traversal/ranked.hpp"

extern "C" uint32_t entry(const flashbvh::PostTree& a, const flashbvh::PostTree& b,
                          const flashbvh::TranslatedOverlap& overlap,
                          flashbvh::PairCursor<uint16_t>& cursor) {
  flashbvh::Budget budget = {1000, 0, false};
  uint32_t leaf_pairs = 0;
  (void)flashbvh::Ranked<flashbvh::PostTree>::run(a, b, overlap, cursor, budget,
                                                  [&leaf_pairs](uint32_t, uint32_t) {
                                                    ++leaf_pairs;
                                                    return true;
                                                  });
  return leaf_pairs + budget.overlaps;
}
