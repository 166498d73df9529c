// first_pair(): the query lies on the stack.
#include "flashbvh/collide.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void first_pair_once(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const Answer answer = first_pair<uint16_t>(*in.a, *in.b, *in.pose, in.found[0]);
  in.answer = answer.yes ? 1 : 0;
  in.status = static_cast<uint8_t>(answer.status);
}
