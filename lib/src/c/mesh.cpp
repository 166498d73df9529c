// The C interface to meshes.
#include "flashbvh/image.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_open(const void* image, size_t size, flashbvh_mesh* mesh) {
  PostMesh opened;
  const Status status = open_image(image, size, opened);
  if (status == Status::done) {
    new (storage_of<PostMesh>(mesh)) PostMesh(opened);
  }
  return c_status(status);
}

uint32_t flashbvh_mesh_triangles(const flashbvh_mesh* mesh) {
  return object_in(mesh).triangle_count;
}

uint64_t flashbvh_mesh_cell(const flashbvh_mesh* mesh) {
  return object_in(mesh).cell_bits;
}
