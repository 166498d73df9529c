// A query in C: started if no visits are granted, else run for a slice.
#include "memory/arguments.hpp"

extern "C" void c_query(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  auto* const query = reinterpret_cast<flashbvh_query*>(in.query.bytes);
  if (in.visits == 0) {
    in.status = static_cast<uint8_t>(flashbvh_query_start(query, in.c_a, in.c_b, in.c_pose));
    return;
  }
  uint32_t count = 0;
  in.status = static_cast<uint8_t>(flashbvh_query_run(
      query, in.visits, reinterpret_cast<flashbvh_pair*>(in.found), in.capacity, &count));
  in.answer += count;
}
