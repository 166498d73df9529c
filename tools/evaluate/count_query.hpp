// Runs one of the paper's queries for its counts.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/query.hpp"
#include "flashbvh/traversal/traversals.hpp"

namespace flashbvh::scene {

/// Initial cursors of one traversal over two trees, with the array that a stack needs.
template <class Traversal>
class WalkStart {
 public:
  WalkStart(const typename Traversal::Tree& a, const typename Traversal::Tree& b)
      : entries_(Traversal::kStackless ? 0 : stack_entries(a.stack_need, b.stack_need)) {}

  /// A cursor at the roots. All cursors share one array: run only one walk at a time.
  typename Traversal::Cursor cursor() {
    if constexpr (Traversal::kStackless) {
      return {};
    } else {
      return {entries_.data(), static_cast<std::uint32_t>(entries_.size())};
    }
  }

 private:
  std::vector<StackEntry<typename Traversal::Tree::Index>> entries_;
};

/// Runs the paper's query, with triangle tests, to its end. Returns zeros if it is refused, or if
/// its count of pairs is not that of the pairs it gives.
template <class Traversal>
QueryStats count_query(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
                       const Pose& pose, WalkStart<Traversal>& start) {
  using QueryType = Query<Traversal, BoxIntersection>;
  QueryType query(a, b, pose, start.cursor());
  const RunResult end = query.run(UINT32_MAX, [](const typename QueryType::Pair&) { return true; });
  const bool is_done = end.status == Status::done && end.count == query.stats().triangle_pairs;
  return is_done ? query.stats() : QueryStats{0, 0, 0, 0};
}

}  // namespace flashbvh::scene
