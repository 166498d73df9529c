// The end of a flashbvh call: its status, and the result and cursor of a query's run.
#pragma once

#include <stdint.h>

#include "flashbvh/plain/language.h"
#include "flashbvh/plain/results.h"
#include "flashbvh/plain/status.h"

namespace flashbvh {

/* clang-format off */
#define FLASHBVH_FOR_EACH_STATUS(status) \
  status(done, DONE) \
  status(suspended, SUSPENDED) \
  status(full, FULL) \
  status(cell_mismatch, CELL_MISMATCH) \
  status(stack_too_small, STACK_TOO_SMALL) \
  status(translation_out_of_range, TRANSLATION_OUT_OF_RANGE) \
  status(not_a_rotation, NOT_A_ROTATION) \
  status(cursor_invalid, CURSOR_INVALID) \
  status(hint_invalid, HINT_INVALID) \
  status(distance_out_of_range, DISTANCE_OUT_OF_RANGE) \
  status(not_closed, NOT_CLOSED) \
  status(shape_too_large, SHAPE_TOO_LARGE) \
  status(ray_out_of_range, RAY_OUT_OF_RANGE) \
  status(not_a_coordinate, NOT_A_COORDINATE) \
  status(joint_out_of_limits, JOINT_OUT_OF_LIMITS) \
  status(joint_jumped, JOINT_JUMPED) \
  status(guard_state_invalid, GUARD_STATE_INVALID) \
  status(workcell_full, WORKCELL_FULL) \
  status(link_invalid, LINK_INVALID) \
  status(vertex_out_of_lattice, VERTEX_OUT_OF_LATTICE) \
  status(mesh_changed, MESH_CHANGED) \
  status(motion_out_of_range, MOTION_OUT_OF_RANGE) \
  status(self_test_failed, SELF_TEST_FAILED) \
  status(not_open, NOT_OPEN) \
  status(image_truncated, IMAGE_TRUNCATED) \
  status(image_misaligned, IMAGE_MISALIGNED) \
  status(image_not_flashbvh, IMAGE_NOT_FLASHBVH) \
  status(image_version, IMAGE_VERSION) \
  status(image_kind, IMAGE_KIND) \
  status(image_corrupt, IMAGE_CORRUPT) \
  status(image_invalid, IMAGE_INVALID) \
  status(image_too_large, IMAGE_TOO_LARGE)
/* clang-format on */

#define FLASHBVH_CONSTANT(name, NAME) name = FLASHBVH_STATUS_##NAME,

/// plain/status.h has the values, which never change, and their meanings. The compiler warns if a
/// status is dropped (plain/language.h).
enum class Status : uint8_t { FLASHBVH_FOR_EACH_STATUS(FLASHBVH_CONSTANT) };

#undef FLASHBVH_CONSTANT

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
