// flashbvh_query_last_pair().
#include "memory/arguments.hpp"

extern "C" void c_last_pair(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  flashbvh_query_last_pair(reinterpret_cast<const flashbvh_query*>(in.query.bytes),
                           reinterpret_cast<flashbvh_triangle*>(&in.placed[0]),
                           reinterpret_cast<flashbvh_triangle*>(&in.placed[1]));
}
