// One traversal of boxes, moved and not turned, without triangles.
#include "flashbvh/detail/ranked.hpp"
#include "memory/arguments.hpp"
#include "support/walk.hpp"

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
  const Counts counts = flashbvh::test::walk_from<Ranked<PostMesh>>(*in.a, *in.b, overlap, in.stack[0],
                                                          leaf_pair, in.visits).counts;
  in.answer = leaf_pairs + counts.overlaps;
}
