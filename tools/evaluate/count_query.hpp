// Runs a query to its end for its counts.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "flashbvh/query.hpp"
#include "reference/traversals.hpp"

namespace flashbvh::scene {

/// Initial cursors of one traversal over two trees, with the array that a stack needs.
template <class Traversal>
class WalkStart {
  using Cursor = typename Traversal::Cursor;
  using Entry = StackEntry<typename Traversal::Tree::Index>;

 public:
  WalkStart(const typename Traversal::Tree& a, const typename Traversal::Tree& b) {
    if constexpr (kStack) {
      entries_.resize(stack_entries(a.stack_need, b.stack_need));
    }
  }

  /// A cursor at the roots. All cursors share one array: run only one walk at a time.
  Cursor cursor() {
    if constexpr (kStack) {
      return Cursor(entries_.data(), static_cast<std::uint32_t>(entries_.size()));
    } else {
      return Cursor();
    }
  }

 private:
  static constexpr bool kStack = !std::is_same_v<Cursor, Entry>;
  std::vector<Entry> entries_;
};

/// Includes geometry tests, with leaves as shapes unless the predicate is `BoxIntersection`.
/// Returns zeros if the query is refused. The sink counts the found pairs, too; both counts must
/// agree.
template <class Traversal, class Predicate = Intersection>
QueryStats count_query(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
                       const Pose& pose, WalkStart<Traversal>& start, std::uint32_t& found) {
  using QueryType = Query<Traversal, Predicate>;
  QueryType query(a, b, pose, start.cursor());
  found = 0;
  const Status status = query
                            .run(UINT32_MAX,
                                 [&found](const typename QueryType::Pair&) {
                                   ++found;
                                   return true;
                                 })
                            .status;
  return status == Status::done ? query.stats() : QueryStats{0, 0, 0, 0};
}

}  // namespace flashbvh::scene
