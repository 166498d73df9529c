// open_image(): every check of a post-indexed image.
#include "flashbvh/image.hpp"
#include "flashbvh/mesh.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void open_an_image(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      open_image(in.image, in.image_size, *reinterpret_cast<LevelledPostMesh*>(in.opened.bytes)));
}
