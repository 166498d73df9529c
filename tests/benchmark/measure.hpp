// Instructions of one walk, and of one whole query.
#ifndef FLASHBVH_TESTS_BENCHMARK_MEASURE_HPP
#define FLASHBVH_TESTS_BENCHMARK_MEASURE_HPP

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "insn.hpp"
#include "support/at_roots.hpp"
#include "support/walk.hpp"

namespace benchmark {

/// Room for the stack of every setup; queries check that it is enough.
constexpr uint32_t kStackEntries = 64;

template <class Traversal>
typename Traversal::Cursor start() {
  static flashbvh::detail::PairCursor<uint16_t> entries[kStackEntries];
  return flashbvh::test::at_roots<Traversal>(entries, kStackEntries);
}

struct Walked {
  uint32_t visits;
  uint32_t overlaps;
  uint32_t leaf_overlaps;
  uint32_t instructions;
};

/// Goes on at each pair of leaves. Holds the count itself: what a walk knows of it is one address.
struct LeafCounter {
  mutable uint32_t count = 0;
  bool operator()(uint32_t /*node_a*/, uint32_t /*node_b*/,
                  const flashbvh::detail::Progress& /*progress*/) const {
    ++count;
    return true;
  }
};

/// The boxes alone, from the start of the walk to its end, pairs of leaves counted.
template <class Traversal>
__attribute__((noinline)) Walked measure_walk(const typename Traversal::Tree& a,
                                              const typename Traversal::Tree& b,
                                              const flashbvh::detail::TranslatedBound& overlap) {
  flashbvh::Counts counts{};
  const LeafCounter leaf_pairs;
  const uint32_t instructions = port::instructions_of([&] {
    auto cursor = start<Traversal>();
    counts = flashbvh::test::walk_from<Traversal>(a, b, overlap, cursor, leaf_pairs).counts;
  });
  return {counts.visits, counts.overlaps, leaf_pairs.count, instructions};
}

struct Queried {
  flashbvh::Status status;
  flashbvh::Counts counts;
  uint32_t instructions;
};

/// A query made, and run to its end, with the triangles of each pair of leaves tested.
template <class Traversal>
__attribute__((noinline)) Queried measure_query(const typename Traversal::Tree& a,
                                                const typename Traversal::Tree& b,
                                                const flashbvh::Pose& pose) {
  using Query = flashbvh::Query<Traversal, flashbvh::detail::BoxIntersection>;
  const auto every_pair = [](const typename Query::Pair&) { return true; };
  Queried result{};
  result.instructions = port::instructions_of([&] {
    Query query(a, b, pose, start<Traversal>());
    result.status = query.run(UINT32_MAX, every_pair).status;
  });
  // Its counts from another run: a user of the first would not copy them.
  Query query(a, b, pose, start<Traversal>());
  (void)query.run(UINT32_MAX, every_pair);
  result.counts = query.counts();
  return result;
}

}  // namespace benchmark

#endif
