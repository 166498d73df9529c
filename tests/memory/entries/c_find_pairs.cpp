// flashbvh_find_pairs().
#include "memory/arguments.hpp"

extern "C" void c_find_pairs(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(flashbvh_find_pairs(in.c_a, in.c_b, in.c_pose,
                                                       reinterpret_cast<flashbvh_pair*>(in.found),
                                                       in.capacity, &in.answer));
}
