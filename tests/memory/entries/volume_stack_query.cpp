// The paper's volume-based stack algorithm as a query; its array of pairs is the caller's.
#include "flashbvh/paper/volume_stack.hpp"
#include "memory/query_entry.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void volume_stack_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_or_run<Query<VolumeStack<PreMesh>>>(in, *in.pre_a, *in.pre_b);
}
