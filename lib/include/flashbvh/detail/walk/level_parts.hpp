// The parts of a mesh with levels: for its opening and the tests.
#ifndef FLASHBVH_DETAIL_WALK_LEVEL_PARTS_HPP
#define FLASHBVH_DETAIL_WALK_LEVEL_PARTS_HPP

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/traversal/levels.hpp"

namespace flashbvh::detail {

/// The array by which a walk climbs: the second one of ImageLevels.
template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::pre_indexed>& mesh) {
  return mesh.parents;
}
template <class Index>
const Index*& climb_of(BasicMeshWithLevels<Index, Layout::post_indexed>& mesh) {
  return mesh.right_child_levels;
}

/// Checks a mesh's contents, and its levels.
template <class Index, Layout layout>
Status check_tree(BasicMeshWithLevels<Index, layout> mesh, TreeShape& shape) {
  const BasicMesh<Index, layout>& tree = mesh;
  return check_tree(tree, {mesh.levels, climb_of(mesh)}, shape);
}

}  // namespace flashbvh::detail

#endif
