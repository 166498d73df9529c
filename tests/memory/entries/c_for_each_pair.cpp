// flashbvh_for_each_pair() with a visitor that takes no stack.
#include "memory/arguments.hpp"

static bool count_visit(flashbvh_pair /*pair*/, void* context) {
  ++*static_cast<uint32_t*>(context);
  return true;
}

extern "C" void c_for_each_pair(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      flashbvh_for_each_pair(in.c_a, in.c_b, in.c_pose, count_visit, &in.answer));
}
