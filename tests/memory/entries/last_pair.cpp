// The triangles of the pair that a query reported last.
#include "flashbvh/query.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void last_pair(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const auto& query = *reinterpret_cast<const PairQuery*>(in.query.bytes);
  query.last_pair(in.placed[0], in.placed[1]);
}
