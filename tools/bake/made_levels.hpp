// Wide trees with levels, and the levels of a tree whose image has none.
#pragma once

#include <cstddef>
#include <vector>

#include "flashbvh/traversal/levels.hpp"

namespace flashbvh {

using PreMeshWithLevels32 = BasicMeshWithLevels<uint32_t, Layout::pre_indexed>;
using MeshWithLevels32 = BasicMeshWithLevels<uint32_t, Layout::post_indexed>;

/// Opens an image as open_image() does, with or without levels. Missing levels are computed into
/// `made`, levels first, then right child levels; `made` must outlive the mesh.
template <class Index, Layout layout>
Status open_levelled(const void* bytes, std::size_t size, BasicMeshWithLevels<Index, layout>& mesh,
                     std::vector<Index>& made) {
  const Status status = open_image(bytes, size, mesh);
  if constexpr (layout == Layout::post_indexed) {
    BasicMesh<Index, layout>& tree = mesh;
    if (status != Status::image_kind || open_image(bytes, size, tree) != Status::done) {
      return status;
    }
    const std::size_t count = tree.node_count;
    made.assign(2 * count, 0);
    for (std::size_t i = 1; i < count; ++i) {
      const bool is_last = tree.nodes[i].link >= i;  // if true, it follows its parent
      const std::size_t from = is_last ? i - 1 : tree.nodes[i].link;
      made[i] = static_cast<Index>(made[from] + (is_last ? 1 : 0));
      made[count + i] = static_cast<Index>(is_last ? made[count + from] + 1 : 0);
    }
    mesh.levels = made.data();
    mesh.right_child_levels = made.data() + count;
    return Status::done;
  }
  return status;
}

}  // namespace flashbvh
