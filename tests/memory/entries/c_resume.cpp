// flashbvh_query_resume().
#include "memory/arguments.hpp"

extern "C" void c_resume(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      flashbvh_query_resume(reinterpret_cast<flashbvh_query*>(in.query.bytes), &in.c_position));
}
