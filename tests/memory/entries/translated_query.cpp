// The same; painted.cpp asks it with poses that only move, and calls.txt leaves the turning walk
// out of its call graph.
#include "flashbvh/query.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;

extern "C" void translated_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<Ranked<PostMesh>>>(in, *in.a, *in.b);
}
