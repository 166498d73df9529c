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

/// Which type a cursor has.
template <class Index>
struct CursorOf {
  /// With wider indices.
  struct Type {
    Index a;
    Index b;
    uint16_t untested;
    QueryState state;
    uint8_t has_witness;
    Index witness_a;
    Index witness_b;
  };
};
/// With those of C.
template <>
struct CursorOf<uint16_t> {
  using Type = flashbvh_cursor;
};

}  // namespace detail

/// A flashbvh_pair, or the same with wider indices.
template <class Index>
using TrianglePair = typename detail::PairOf<Index>::Type;

using RunResult = flashbvh_run_result;

/// A flashbvh_cursor, 12 bytes, or the same with wider indices, 20 bytes: where a stackless query
/// stands between runs.
template <class Index>
using QueryCursor = typename detail::CursorOf<Index>::Type;

}  // namespace flashbvh

#endif
