// flashbvh_intersects().
#include "memory/arguments.hpp"

extern "C" void c_intersects(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  bool yes = false;
  in.status = static_cast<uint8_t>(flashbvh_intersects(in.c_a, in.c_b, in.c_pose, &yes));
  in.answer = yes ? 1 : 0;
}
