// Opens images with levels.
#include "flashbvh/traversal/levels.hpp"

#include "flashbvh/detail/lattice/image_parts.hpp"

namespace flashbvh {
namespace {

/// The array by which a walk climbs: the second one of ImageLevels.
template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::pre_indexed>& mesh) {
  return mesh.parents;
}
template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::post_indexed>& mesh) {
  return mesh.right_child_levels;
}

/// `opened`: of this image. Leaves `mesh` closed, and returns false, if the image has no levels.
template <class Index, Layout layout>
bool set_levels(const void* image, const BasicMesh<Index, layout>& opened,
                BasicMeshWithLevels<Index, layout>& mesh) {
  const detail::ImageLevels<Index> levels = detail::image_levels<Index>(image);
  if (levels.levels == nullptr) {
    return false;
  }
  static_cast<BasicMesh<Index, layout>&>(mesh) = opened;
  mesh.levels = levels.levels;
  climb_of(mesh) = levels.climb;
  return true;
}

}  // namespace

template <class Index, Layout layout>
Status open_image(const void* bytes, size_t size, BasicMeshWithLevels<Index, layout>& mesh) {
  BasicMesh<Index, layout> opened;
  const Status status = open_image(bytes, size, opened);
  mesh = {};
  if (status != Status::done) {
    return status;
  }
  return set_levels(bytes, opened, mesh) ? Status::done : Status::image_kind;
}

template <>
PreMeshWithLevels view_unchecked<PreMeshWithLevels>(const void* image) {
  PreMeshWithLevels mesh = {};
  (void)set_levels(image, view_unchecked<PreMesh>(image), mesh);
  return mesh;
}

template <>
MeshWithLevels view_unchecked<MeshWithLevels>(const void* image) {
  MeshWithLevels mesh = {};
  (void)set_levels(image, view_unchecked<Mesh>(image), mesh);
  return mesh;
}

template Status open_image(const void*, size_t,
                           BasicMeshWithLevels<uint16_t, Layout::pre_indexed>&);
template Status open_image(const void*, size_t,
                           BasicMeshWithLevels<uint16_t, Layout::post_indexed>&);
template Status open_image(const void*, size_t,
                           BasicMeshWithLevels<uint32_t, Layout::pre_indexed>&);
template Status open_image(const void*, size_t,
                           BasicMeshWithLevels<uint32_t, Layout::post_indexed>&);

}  // namespace flashbvh
