// All of one exact query under any rigid pose: made, run in slices to its end.
#include "flashbvh/query.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;

extern "C" void rigid_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<Ranked<PostMesh>>>(in, *in.a, *in.b);
}
