// The end of a flashbvh call: its status, and the result and cursor of a query's run.
#ifndef FLASHBVH_STATUS_HPP
#define FLASHBVH_STATUS_HPP

#include <stdint.h>

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/status.h"

namespace flashbvh {

/// plain/status.h has the values, which never change, and their meanings. The compiler warns if a
/// status is dropped (plain/language.h).
enum class Status : uint8_t {
  done = FLASHBVH_STATUS_DONE,
  suspended = FLASHBVH_STATUS_SUSPENDED,
  full = FLASHBVH_STATUS_FULL,

  cell_mismatch = FLASHBVH_STATUS_CELL_MISMATCH,
  stack_too_small = FLASHBVH_STATUS_STACK_TOO_SMALL,
  translation_out_of_range = FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE,
  not_a_rotation = FLASHBVH_STATUS_NOT_A_ROTATION,
  cursor_invalid = FLASHBVH_STATUS_CURSOR_INVALID,
  hint_invalid = FLASHBVH_STATUS_HINT_INVALID,
  distance_out_of_range = FLASHBVH_STATUS_DISTANCE_OUT_OF_RANGE,
  not_closed = FLASHBVH_STATUS_NOT_CLOSED,
  shape_too_large = FLASHBVH_STATUS_SHAPE_TOO_LARGE,
  ray_out_of_range = FLASHBVH_STATUS_RAY_OUT_OF_RANGE,
  not_a_coordinate = FLASHBVH_STATUS_NOT_A_COORDINATE,
  joint_out_of_limits = FLASHBVH_STATUS_JOINT_OUT_OF_LIMITS,
  joint_jumped = FLASHBVH_STATUS_JOINT_JUMPED,
  guard_state_invalid = FLASHBVH_STATUS_GUARD_STATE_INVALID,
  workcell_full = FLASHBVH_STATUS_WORKCELL_FULL,
  link_invalid = FLASHBVH_STATUS_LINK_INVALID,
  vertex_out_of_lattice = FLASHBVH_STATUS_VERTEX_OUT_OF_LATTICE,
  mesh_changed = FLASHBVH_STATUS_MESH_CHANGED,
  motion_out_of_range = FLASHBVH_STATUS_MOTION_OUT_OF_RANGE,
  self_test_failed = FLASHBVH_STATUS_SELF_TEST_FAILED,
  not_open = FLASHBVH_STATUS_NOT_OPEN,

  image_truncated = FLASHBVH_STATUS_IMAGE_TRUNCATED,
  image_misaligned = FLASHBVH_STATUS_IMAGE_MISALIGNED,
  image_not_flashbvh = FLASHBVH_STATUS_IMAGE_NOT_FLASHBVH,
  image_version = FLASHBVH_STATUS_IMAGE_VERSION,
  image_kind = FLASHBVH_STATUS_IMAGE_KIND,
  image_corrupt = FLASHBVH_STATUS_IMAGE_CORRUPT,
  image_invalid = FLASHBVH_STATUS_IMAGE_INVALID,
  image_too_large = FLASHBVH_STATUS_IMAGE_TOO_LARGE,
};

/// As flashbvh_status_name().
inline const char* status_name(Status status) {
  return flashbvh_status_name(static_cast<flashbvh_status>(status));
}

namespace detail {

/// The types of pairs and cursors with indices of this type.
template <class Index>
struct TypesOf {
  /// With wider indices.
  struct Pair {
    Index a;
    Index b;
  };
  /// With wider indices.
  struct Cursor {
    Index a;
    Index b;
    uint16_t untested;
    QueryState state;
    uint8_t has_witness;
    Index witness_a;
    Index witness_b;
  };
};
/// The types that C has too.
template <>
struct TypesOf<uint16_t> {
  using Pair = flashbvh_pair;
  using Cursor = flashbvh_cursor;
};

}  // namespace detail

/// A flashbvh_pair, or a struct of equal fields with wider indices.
template <class Index>
using TrianglePair = typename detail::TypesOf<Index>::Pair;

using RunResult = flashbvh_run_result;

/// A stackless query's cursor between runs: a flashbvh_cursor, 12 bytes, or a struct of equal
/// fields with wider indices, 20 bytes.
template <class Index>
using QueryCursor = typename detail::TypesOf<Index>::Cursor;

}  // namespace flashbvh

#endif
