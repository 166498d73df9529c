// The library of pages, compiled for WebAssembly: memory, and baked meshes in it. All memory lies
// after the linked data, and is never freed.
#pragma once

#include <stddef.h>

#include "flashbvh/mesh.hpp"

#define EXPORT extern "C" __attribute__((visibility("default"), used))

namespace page {

constexpr uint32_t kMostMeshes = 64;
constexpr double kFineCells = 256;  // steps of a distance in a cell

extern flashbvh::Mesh meshes[kMostMeshes];
extern const void* room_taken;  // the last allocation for an image

/// Allocates zeros at a multiple of 8.
void* take(size_t bytes);
template <class Type>
Type* take(size_t count) {
  return static_cast<Type*>(take(count * sizeof(Type)));
}

/// A mesh's cell in its unit.
double cell(uint32_t mesh = 0);

}  // namespace page
