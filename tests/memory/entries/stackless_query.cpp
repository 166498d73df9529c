// The paper's stackless algorithm as a query.
#include "flashbvh/paper/stackless.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void stackless_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<Stackless>>(in, *in.pre_a, *in.pre_b);
}
