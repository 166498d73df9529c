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
  uint32_t leaf_pairs = 0;
  auto found = [&](uint32_t i, uint32_t j, const detail::Progress&) {
    ++leaf_pairs;
    return leaf_pair(i, j);
  };
  detail::NoShapes<typename Order::Tree> shapes = {a, b};
  detail::WalkRun<typename Order::Cursor, decltype(found)> run = {&cursor, &found, {visits, 0}};
  const detail::State end = detail::walk<Order>(
      bound, shapes, run, after ? detail::State::at_leaf_pair : detail::State::at_pair);
  Walked walked = {end, {visits - run.progress.visits_left, run.progress.overlaps, leaf_pairs, 0}};
  return walked;
}

}  // namespace flashbvh::test

#endif
