// check_tree() on its own.
#include "flashbvh/detail/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" void check_a_tree(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status =
      static_cast<uint8_t>(check_tree(*in.a, *reinterpret_cast<TreeShape*>(in.opened.bytes)));
}
