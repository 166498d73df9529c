// Walks over boxes alone, without a query: from a cursor on, however many pairs of leaves come.
#ifndef FLASHBVH_TESTS_SUPPORT_WALK_HPP
#define FLASHBVH_TESTS_SUPPORT_WALK_HPP

#include <stdint.h>

#include "flashbvh/detail/walk.hpp"

namespace flashbvh::test {

struct Walked {
  detail::State end;
  Counts counts;  ///< visits and overlaps
};

/// At most `visits` visits from `cursor` on, or after its pair. `leaf_pair(i, j)` is asked at each
/// pair of leaves whether to go on.
template <class Order, class Bound, class LeafPair>
Walked walk_from(const typename Order::Tree& a, const typename Order::Tree& b, const Bound& bound,
                 typename Order::Cursor& cursor, const LeafPair& leaf_pair,
                 uint32_t visits = UINT32_MAX, bool after = false) {
  Walked walked = {detail::State::fresh, {0, 0, 0, 0}};
  const detail::WalkRun<typename Order::Cursor, LeafPair> run = {&cursor, &walked.counts, &visits,
                                                                 &leaf_pair};
  walked.end = detail::walk<Order>(a, b, bound, run, after);
  return walked;
}

}  // namespace flashbvh::test

#endif
