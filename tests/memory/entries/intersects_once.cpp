// intersects(): the query lies on the stack.
#include "flashbvh/collide.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void intersects_once(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  const Answer answer = intersects<uint16_t>(*in.a, *in.b, *in.pose);
  in.answer = answer.yes ? 1 : 0;
  in.status = static_cast<uint8_t>(answer.status);
}
