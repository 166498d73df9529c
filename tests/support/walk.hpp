// Walks over boxes alone, without a query: from a cursor on, however many pairs of leaves come.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk.hpp"

namespace flashbvh::test {

struct Walked {
  detail::State end;
  QueryStats counts;  ///< visits and overlaps
};

/// At most `visits` visits from `cursor` on, or after its pair. `leaf_pair(i, j, progress)` is
/// called at each pair of leaves whether to go on.
template <class Traversal, class BoxTest, class LeafPair>
Walked walk_from(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
                 const BoxTest& bound, typename Traversal::Cursor& cursor,
                 const LeafPair& leaf_pair, uint32_t visits = UINT32_MAX, bool after = false) {
  detail::NoShapes<typename Traversal::Tree> shapes = {a, b};
  detail::WalkRun<typename Traversal::Cursor, const LeafPair> run(cursor, leaf_pair, visits);
  const detail::State end = detail::walk<Traversal>(
      bound, shapes, run, after ? detail::State::at_leaf_pair : detail::State::at_pair);
  Walked walked = {end, {visits - run.progress.visits_down(), run.progress.overlaps, 0, 0}};
  return walked;
}

}  // namespace flashbvh::test
