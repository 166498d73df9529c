// Walks over boxes without a query, from a cursor on.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk.hpp"

namespace flashbvh::test {

struct Walked {
  detail::State end;
  QueryStats counts;  ///< visits and overlaps
};

/// Continues for at most `visits` visits from `cursor`, or after its pair. At each pair of leaves,
/// `leaf_pair(i, j, progress)` returns whether to continue.
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
