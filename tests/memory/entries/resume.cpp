// A made query taken to a position.
#include "flashbvh/query.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void resume(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  auto& query = *reinterpret_cast<PairQuery*>(in.query.bytes);
  in.status = static_cast<uint8_t>(query.resume(in.position));
}
