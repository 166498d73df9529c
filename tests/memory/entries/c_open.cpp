// flashbvh_open().
#include "memory/arguments.hpp"

extern "C" void c_open(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      flashbvh_open(in.image, in.image_size, reinterpret_cast<flashbvh_mesh*>(in.opened.bytes)));
}
