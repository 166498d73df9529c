// The only list of the traversals and their names, in the order of the paper's tables, then ours.
//
// Uses no C++ library and no heap, so that firmware can include it.
#pragma once

#include "flashbvh/detail/query/intersection.hpp"
#include "flashbvh/detail/walk/ranked.hpp"
#include "flashbvh/mesh.hpp"
#include "reference/leaf.hpp"
#include "reference/stack_traversals.hpp"
#include "reference/stackless.hpp"

namespace flashbvh {

/// The predicates of the paper's counts: with leaf planes, and by boxes alone.
using Intersection = detail::Intersection;
using BoxIntersection = detail::BoxIntersection;

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
  use(NamedTraversal<VolumeStack, BasicMesh, true, true>{"volume-stack"});
  use(NamedTraversal<AlternatingStack, BasicMeshWithLevels, true, true>{"alternating-stack"});
  use(NamedTraversal<AlternatingStackless, BasicMeshWithLevels, true, false>{"stackless"});
  use(NamedTraversal<AlternatingStackless, BasicMeshWithLevels, false, true>{"stackless-post"});
  use(NamedTraversal<Leaf, BasicMesh, true, true>{"leaf"});
  use(NamedTraversal<Ranked, BasicMesh, false, true>{"ranked"});
  use(NamedTraversal<RankedStack, BasicMesh, false, true>{"ranked-stack"});
}

/// The default traversal for two meshes in this layout.
constexpr const char* default_traversal(Layout layout) {
  return layout == Layout::post_indexed ? "ranked" : "stackless";
}

}  // namespace flashbvh
