// The traversals by their names: the one list of them, in the order of the paper's tables, ours
// last.
//
// Nothing of C++'s library and no heap, so that firmware may use it.
#ifndef FLASHBVH_TOOLS_EVALUATE_TRAVERSALS_HPP
#define FLASHBVH_TOOLS_EVALUATE_TRAVERSALS_HPP

#include "flashbvh/levels.hpp"
#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/ranked_stack.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/volume_stack.hpp"

namespace flashbvh {

/// `Traversal`: of a type of trees, which are `Trees`; it walks them in the layouts that are true.
template <template <class> class Traversal, template <class, Layout> class Trees, bool pre,
          bool post>
struct NamedTraversal {
  template <class Index, Layout layout>
  using On = Traversal<Trees<Index, layout>>;

  /// Where the paper has it; ours on ours.
  static constexpr Layout kLayout = pre ? Layout::pre_indexed : Layout::post_indexed;
  static constexpr bool walks(Layout layout) { return layout == Layout::pre_indexed ? pre : post; }

  const char* name;
};

/// Calls use(NamedTraversal<...>) for each.
template <class Use>
constexpr void for_each_traversal(Use&& use) {
  use(NamedTraversal<VolumeStack, Tree, true, true>{"volume-stack"});
  use(NamedTraversal<AlternatingStack, LevelledTree, true, true>{"alternating-stack"});
  use(NamedTraversal<AlternatingStackless, LevelledTree, true, false>{"stackless"});
  use(NamedTraversal<AlternatingStackless, LevelledTree, false, true>{"stackless-post"});
  use(NamedTraversal<Leaf, Tree, true, true>{"leaf"});
  use(NamedTraversal<Ranked, Tree, false, true>{"ranked"});
  use(NamedTraversal<RankedStack, Tree, false, true>{"ranked-stack"});
}

/// Of two trees in this layout.
constexpr const char* default_traversal(Layout layout) {
  return layout == Layout::post_indexed ? "ranked" : "stackless";
}

}  // namespace flashbvh

#endif
