// Instructions of one walk, and of one whole query.
#ifndef FLASHBVH_TESTS_BENCHMARK_MEASURE_HPP
#define FLASHBVH_TESTS_BENCHMARK_MEASURE_HPP

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "support/walk.hpp"
#include "flashbvh/paper/pair_stack.hpp"
#include "insn.hpp"

namespace benchmark {

/// Room for the stack of every setup; queries check that it is enough.
constexpr uint32_t kStackEntries = 64;

/// Where a walk starts.
template <class Cursor>
struct Start;

template <>
struct Start<flashbvh::detail::PairCursor<uint16_t>> {
  static flashbvh::detail::PairCursor<uint16_t> cursor() { return {}; }
};

template <>
struct Start<flashbvh::PairStack<uint16_t>> {
  static flashbvh::PairStack<uint16_t> cursor() {
    static flashbvh::detail::PairCursor<uint16_t> entries[kStackEntries];
    return {entries, kStackEntries};
  }
};

struct Walked {
  uint32_t visits;
  uint32_t overlaps;
  uint32_t leaf_overlaps;
  uint32_t instructions;
};

/// The boxes alone, from the start of the walk to its end, pairs of leaves counted.
template <class Traversal>
__attribute__((noinline)) Walked measure_walk(const typename Traversal::Tree& a,
                                              const typename Traversal::Tree& b,
                                              const flashbvh::detail::TranslatedBound& overlap) {
  flashbvh::Counts counts{};
  uint32_t leaf_overlaps = 0;
  const uint32_t instructions = port::instructions_of([&] {
    auto cursor = Start<typename Traversal::Cursor>::cursor();
    const auto leaf_pair = [&leaf_overlaps](uint32_t, uint32_t) {
      ++leaf_overlaps;
      return true;
    };
    counts = flashbvh::test::walk_from<Traversal>(a, b, overlap, cursor, leaf_pair).counts;
  });
  return {counts.visits, counts.overlaps, leaf_overlaps, instructions};
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
  using Query = flashbvh::Query<Traversal>;
  const auto every_pair = [](const typename Query::Pair&) { return true; };
  const auto start = [] { return Start<typename Traversal::Cursor>::cursor(); };
  Queried result{};
  result.instructions = port::instructions_of([&] {
    Query query(a, b, pose, start());
    result.status = query.run(UINT32_MAX, every_pair);
  });
  // Its counts from another run: a user of the first would not copy them.
  Query query(a, b, pose, start());
  (void)query.run(UINT32_MAX, every_pair);
  result.counts = query.counts();
  return result;
}

}  // namespace benchmark

#endif
