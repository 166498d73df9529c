// What a run of a query gives, and where a query stands between runs.
#ifndef FLASHBVH_RUN_RESULT_HPP
#define FLASHBVH_RUN_RESULT_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/plain/results.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

namespace detail {

/// Which type a pair of triangles' ids has.
template <class Index>
struct PairOf {
  /// With wider indices.
  struct Type {
    Index a;
    Index b;
  };
};
/// With those of C.
template <>
struct PairOf<uint16_t> {
  using Type = flashbvh_pair;
};

}  // namespace detail

/// A flashbvh_pair, or the same with wider indices.
template <class Index>
using TrianglePair = typename detail::PairOf<Index>::Type;

using RunResult = flashbvh_run_result;

/// Where a stackless query stands, between runs: all there is to keep beside what the query was
/// made of, its meshes and its pose. May be stored for any time, as bytes too: 12 of them with
/// 16-bit indices.
template <class IndexType>
struct QueryCursor {
  using State = detail::State;

  IndexType a = 0;
  IndexType b = 0;
  uint32_t untested = 0;  ///< pairs of triangles that the pair of leaves still has
  State state = State::fresh;
};

}  // namespace flashbvh

#endif
