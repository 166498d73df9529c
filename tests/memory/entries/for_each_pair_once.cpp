// for_each_pair(): the query lies on the stack. The visitor is inlined.
#include "flashbvh/collide.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void for_each_pair_once(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      for_each_pair<uint16_t>(*in.a, *in.b, *in.pose, [&in](const PairQuery::Pair& pair) {
        in.found[in.answer++ % 4] = pair;
        return true;
      }));
}
