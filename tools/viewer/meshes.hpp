// Shared by the WebAssembly libraries of all pages: memory, and baked meshes in it. All memory lies
// after the linked data, and is never freed.
#pragma once

#include <stddef.h>

#include "../wasm.hpp"
#include "flashbvh/mesh.hpp"

namespace live {

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

/// fine_length_rounded_up() of the float that is not below `length`, in the mesh's unit.
flashbvh::FineLength fine_length_rounded_up(double length, uint32_t mesh = 0);

}  // namespace live
