// The rule of ranked with a stack as a query; its array of pairs is the caller's.
#include "flashbvh/paper/ranked_stack.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void ranked_stack_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<RankedStack<PostMesh>>>(in, *in.a, *in.b);
}
