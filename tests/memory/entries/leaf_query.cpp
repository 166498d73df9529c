// The paper's leaf algorithm as a query.
#include "flashbvh/paper/leaf.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void leaf_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<Leaf<PreMesh>>>(in, *in.pre_a, *in.pre_b);
}
