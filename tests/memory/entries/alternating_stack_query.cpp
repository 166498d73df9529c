// The paper's alternating stack algorithm as a query; its array of pairs is the caller's.
#include "flashbvh/paper/alternating_stack.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void alternating_stack_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<AlternatingStack<LevelledPostMesh>>>(in, *in.a, *in.b);
}
