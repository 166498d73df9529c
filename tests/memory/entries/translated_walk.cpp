// One traversal of boxes, moved and not turned, without triangles.
#include "flashbvh/traversal/ranked.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void translated_walk(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const TranslatedOverlap& overlap = *reinterpret_cast<TranslatedOverlap*>(in.made_pose.bytes);
  Budget budget = {in.visits, 0, false};
  uint32_t leaf_pairs = 0;
  (void)Ranked<PostTree>::run(*in.a, *in.b, overlap, in.stack[0], budget,
                              [&leaf_pairs](uint32_t, uint32_t) {
                                ++leaf_pairs;
                                return true;
                              });
  in.answer = leaf_pairs + budget.overlaps;
}
