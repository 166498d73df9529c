// The result of a query's run, and a query's cursor between runs.
#ifndef FLASHBVH_RUN_RESULT_HPP
#define FLASHBVH_RUN_RESULT_HPP

#include <stdint.h>

#include "flashbvh/detail/walk/walk_run.hpp"
#include "flashbvh/plain/results.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

namespace detail {

/// Selects the type of a pair of triangles' ids by the index type.
template <class Index>
struct PairOf {
  /// The type with wider indices.
  struct Type {
    Index a;
    Index b;
  };
};
/// The type that C has too.
template <>
struct PairOf<uint16_t> {
  using Type = flashbvh_pair;
};

/// Selects a cursor's type by the index type.
template <class Index>
struct CursorOf {
  /// The type with wider indices.
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
/// The type that C has too.
template <>
struct CursorOf<uint16_t> {
  using Type = flashbvh_cursor;
};

}  // namespace detail

/// A flashbvh_pair, or a struct of equal fields with wider indices.
template <class Index>
using TrianglePair = typename detail::PairOf<Index>::Type;

using RunResult = flashbvh_run_result;

/// A stackless query's cursor between runs: a flashbvh_cursor, 12 bytes, or a struct of equal
/// fields with wider indices, 20 bytes.
template <class Index>
using QueryCursor = typename detail::CursorOf<Index>::Type;

}  // namespace flashbvh

#endif
