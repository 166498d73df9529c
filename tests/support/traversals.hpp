// Every traversal that trees of a type can take, by its name on the command line.
#ifndef FLASHBVH_TESTS_SUPPORT_TRAVERSALS_HPP
#define FLASHBVH_TESTS_SUPPORT_TRAVERSALS_HPP

#include <cstdint>
#include <type_traits>
#include <vector>

#include "flashbvh/query.hpp"
#include "flashbvh/paper/alternating_stack.hpp"
#include "flashbvh/paper/leaf.hpp"
#include "flashbvh/detail/ranked.hpp"
#include "flashbvh/paper/ranked_stack.hpp"
#include "flashbvh/paper/stackless.hpp"
#include "flashbvh/paper/volume_stack.hpp"

namespace flashbvh::test {

/// Calls use(name, Query<...>&) with a fresh stackless query for each traversal that takes `Tree`.
template <class Tree, class Use>
void for_each_stackless(const Tree& a, const Tree& b, const Pose& pose, Use use) {
  const auto run = [&](const char* name, auto query) { use(name, query); };
  run("leaf", Query<Leaf<Tree>>(a, b, pose));
  run("stackless", Query<AlternatingStackless<Tree>>(a, b, pose));
  if constexpr (Tree::kLayout == Layout::post_indexed) {
    run("ranked", Query<Ranked<Tree>>(a, b, pose));
  }
}

/// The same for those that need a stack, each on an array of exactly stack_entries() entries.
template <class Tree, class Use>
void for_each_stack(const Tree& a, const Tree& b, const Pose& pose, Use use) {
  const auto entry_count = stack_entries(a.stack_need, b.stack_need);
  const auto run = [&](const char* name, auto* order) {
    using Traversal = std::remove_pointer_t<decltype(order)>;
    std::vector<detail::PairCursor<typename Tree::Index>> entries(entry_count);
    Query<Traversal> query(a, b, pose, {entries.data(), entry_count});
    use(name, query);
  };
  run("volume-stack", static_cast<VolumeStack<Tree>*>(nullptr));
  run("alternating-stack", static_cast<AlternatingStack<Tree>*>(nullptr));
  if constexpr (Tree::kLayout == Layout::post_indexed) {
    run("ranked-stack", static_cast<RankedStack<Tree>*>(nullptr));
  }
}

template <class Tree, class Use>
void for_each_traversal(const Tree& a, const Tree& b, const Pose& pose, Use use) {
  for_each_stackless(a, b, pose, use);
  for_each_stack(a, b, pose, use);
}

}  // namespace flashbvh::test

#endif
