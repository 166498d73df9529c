#include "library.hpp"

extern "C" unsigned char __heap_base;  // of wasm-ld

namespace page {

using namespace flashbvh;

Mesh meshes[kMostMeshes];
const void* room_taken;

void* take(size_t bytes) {
  constexpr uintptr_t kPage = 65536;
  static unsigned char* end = &__heap_base;
  const uintptr_t begin = (reinterpret_cast<uintptr_t>(end) + 7) / 8 * 8;
  end = reinterpret_cast<unsigned char*>(begin + bytes);
  const uintptr_t pages = (begin + bytes + kPage - 1) / kPage;
  const auto has = static_cast<uintptr_t>(__builtin_wasm_memory_size(0));
  if (pages > has && __builtin_wasm_memory_grow(0, pages - has) == SIZE_MAX) {
    __builtin_trap();
  }
  return reinterpret_cast<void*>(begin);
}

double cell(uint32_t mesh) {
  double length = 0;
  __builtin_memcpy(&length, &meshes[mesh].cell_bits, sizeof length);
  return length;
}

/// Allocates memory for an image.
EXPORT void* room(uint32_t bytes) {
  room_taken = take(bytes);
  return const_cast<void*>(room_taken);
}

/// Three 16-bit numbers per vertex and per triangle.
EXPORT const void* vertices(uint32_t mesh) {
  return meshes[mesh].vertices;
}
EXPORT uint32_t vertex_count(uint32_t mesh) {
  return meshes[mesh].vertex_count;
}
EXPORT const void* triangles(uint32_t mesh) {
  return meshes[mesh].triangles;
}
EXPORT uint32_t triangle_count(uint32_t mesh) {
  return meshes[mesh].triangle_count;
}

}  // namespace page
