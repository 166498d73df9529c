// flashbvh_count_pairs().
#include "memory/arguments.hpp"

extern "C" void c_count_pairs(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(flashbvh_count_pairs(in.c_a, in.c_b, in.c_pose, &in.answer));
}
