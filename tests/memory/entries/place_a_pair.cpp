// The triangles of a reported pair, placed again by their source numbers.
#include "flashbvh/contact.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void place_a_pair(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.answer = transform_pair<PostMesh>(*in.a, *in.b, *in.pose, in.found[0], in.placed[0], in.placed[1])
                  ? 1u
                  : 0u;
}
