// flashbvh_first_pair().
#include "memory/arguments.hpp"

extern "C" void c_first_pair(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  bool yes = false;
  in.status = static_cast<uint8_t>(flashbvh_first_pair(in.c_a, in.c_b, in.c_pose, &yes,
                                                       reinterpret_cast<flashbvh_pair*>(in.found)));
  in.answer = yes ? 1 : 0;
}
