// The C interface to trees.
#include "c_objects.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/levels.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_open(const void* image, size_t size, flashbvh_tree* tree) {
  LevelledPostTree opened;
  const Status status = open_image(image, size, opened);
  if (status == Status::done) {
    // Without the levels, which the query does not need.
    new (storage_of<PostTree>(tree)) PostTree(opened);
  }
  return c_status(status);
}

uint32_t flashbvh_tree_triangles(const flashbvh_tree* tree) {
  return object_in(tree).triangle_count;
}

uint64_t flashbvh_tree_cell(const flashbvh_tree* tree) {
  return object_in(tree).cell_bits;
}
