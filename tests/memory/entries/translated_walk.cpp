// One traversal of boxes, moved and not turned, without triangles.
#include "flashbvh/detail/ranked.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void translated_walk(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const TranslatedBound& overlap = *reinterpret_cast<TranslatedBound*>(in.made_pose.bytes);
  uint32_t leaf_pairs = 0;
  const auto leaf_pair = [&leaf_pairs](uint32_t, uint32_t) {
    ++leaf_pairs;
    return true;
  };
  Counts counts;
  counts.visits = 0;
  counts.overlaps = 0;
  const WalkRun<PairCursor<uint16_t>, decltype(leaf_pair)> run = {&in.stack[0], &counts, &in.visits,
                                                                  &leaf_pair};
  (void)walk<Ranked<PostMesh>>(*in.a, *in.b, overlap, run, false);
  in.answer = leaf_pairs + counts.overlaps;
}
