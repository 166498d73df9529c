// The paper's post-indexed stackless algorithm as a query.
#include "flashbvh/paper/stackless.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void stackless_post_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<StacklessPost>>(in, *in.a, *in.b);
}
