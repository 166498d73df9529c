// count_pairs(): the query lies on the stack.
#include "flashbvh/collide.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void count_pairs_once(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const PairCount count = count_pairs<uint16_t>(*in.a, *in.b, *in.pose);
  in.answer = count.pairs;
  in.status = static_cast<uint8_t>(count.status);
}
