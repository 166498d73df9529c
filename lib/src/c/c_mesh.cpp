// The C interface to meshes.
#include "flashbvh/image.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_UNIT_FOOT == static_cast<int>(Unit::foot) &&
                  FLASHBVH_UNIT_FOOT + 1 == kUnitCount,
              "one list of units");

flashbvh_status flashbvh_open(const void* image, size_t size, flashbvh_mesh* mesh) {
  return c_status(open_image(image, size, make(mesh)));
}

void flashbvh_view_unchecked(const void* image, flashbvh_mesh* mesh) {
  make(mesh, view_unchecked<Mesh>(image));
}

uint32_t flashbvh_mesh_triangles(const flashbvh_mesh* mesh) {
  return object_in(mesh).triangle_count;
}

uint64_t flashbvh_mesh_cell(const flashbvh_mesh* mesh) {
  return object_in(mesh).cell_bits;
}

flashbvh_unit flashbvh_mesh_unit(const flashbvh_mesh* mesh) {
  return static_cast<flashbvh_unit>(object_in(mesh).unit);
}

void flashbvh_mesh_origin(const flashbvh_mesh* mesh, int32_t origin[3]) {
  for (int i = 0; i < 3; ++i) {
    origin[i] = object_in(mesh).origin[i];
  }
}

bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh) {
  return object_in(mesh).is_closed;
}
