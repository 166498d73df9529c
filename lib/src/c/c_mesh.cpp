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

flashbvh_unit flashbvh_mesh_unit(const flashbvh_mesh* mesh) {
  return static_cast<flashbvh_unit>(object_in(mesh).unit);
}

bool flashbvh_mesh_is_closed(const flashbvh_mesh* mesh) {
  return object_in(mesh).is_closed;
}
