// Walks over boxes without a query.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/walk/walk.hpp"

namespace flashbvh::test {

struct Walked {
  detail::State end;
  QueryStats counts;  ///< visits and overlaps
};

/// Walks from `cursor` on, for at most `visits` visits. At each pair of leaves,
/// `leaf_pair(i, j, progress)` returns whether to continue.
template <class Traversal, class BoxTest, class LeafPair>
Walked walk_from(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
                 const BoxTest& bound, typename Traversal::Cursor& cursor,
                 const LeafPair& leaf_pair, uint32_t visits = UINT32_MAX) {
  detail::NoShapes<typename Traversal::Tree> shapes = {a, b};
  detail::WalkRun<typename Traversal::Cursor, const LeafPair> run(cursor, leaf_pair, visits);
  const detail::State end = detail::walk<Traversal>(bound, shapes, run, detail::State::at_pair);
  return {end, {visits - run.progress.visits_down(), run.progress.overlaps, 0, 0}};
}

}  // namespace flashbvh::test
