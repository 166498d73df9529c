// triangles_intersect(): the exact test alone.
#include "flashbvh/detail/triangle.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void triangles_meet(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.answer = triangles_intersect(in.triangles[0], in.triangles[1]) ? 1 : 0;
}
