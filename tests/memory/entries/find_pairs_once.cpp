// find_pairs(): the query lies on the stack.
#include "flashbvh/collide.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void find_pairs_once(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const Step step = find_pairs<uint16_t>(*in.a, *in.b, *in.pose, in.found, in.capacity);
  in.answer = step.count;
  in.status = static_cast<uint8_t>(step.status);
}
