// All traversals and their names: the paper's five, in the order of its tables, then `ranked`.
#pragma once

#include "flashbvh/mesh.hpp"
#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/levels.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/volume_stack.hpp"

namespace flashbvh {

/// `Traversal` walks meshes of the type `Meshes`, in the layouts whose flag is true.
template <template <class> class Traversal, template <class, Layout> class Meshes, bool pre,
          bool post>
struct NamedTraversal {
  template <class Index, Layout layout>
  using On = Traversal<Meshes<Index, layout>>;

  /// The paper's layout; for our traversals, ours.
  static constexpr Layout kLayout = pre ? Layout::pre_indexed : Layout::post_indexed;
  static constexpr bool walks(Layout layout) {
    return (pre && layout == Layout::pre_indexed) || (post && layout == Layout::post_indexed);
  }

  const char* name;
};

/// Calls use(NamedTraversal<...>) for each traversal.
template <class Use>
constexpr void for_each_traversal(Use&& use) {
  use(NamedTraversal<BasicVolumeStack, BasicMesh, true, true>{"volume-stack"});
  use(NamedTraversal<BasicAlternatingStack, BasicMeshWithLevels, true, true>{"alternating-stack"});
  use(NamedTraversal<BasicStackless, BasicMeshWithLevels, true, false>{"stackless"});
  use(NamedTraversal<BasicStackless, BasicMeshWithLevels, false, true>{"stackless-post"});
  use(NamedTraversal<BasicLeaf, BasicMesh, true, true>{"leaf"});
  use(NamedTraversal<Ranked, BasicMesh, false, true>{"ranked"});
}

}  // namespace flashbvh
