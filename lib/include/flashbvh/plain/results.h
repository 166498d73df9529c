/* Results of queries, and the size of a tree. */
#pragma once

#include "flashbvh/plain/language.h"

/** Two triangles that a query reports, by their ids: their numbers in the source meshes. */
typedef struct flashbvh_pair {
  uint16_t a;
  uint16_t b;
} flashbvh_pair;

/** The result of a query's run. */
typedef struct FLASHBVH_KEEP flashbvh_run_result {
  FLASHBVH_BYTE(Status) status; /**< a flashbvh_status */
  uint32_t count; /**< pairs written to the caller's array, or passed to its visitor */
  uint32_t work;  /**< work spent; 0 if UINT32_MAX was granted */
} flashbvh_run_result;

/** A cursor of a query of any kind between runs: with its meshes and its pose all that is needed to
 * resume. May be stored for any time, as bytes too. */
typedef struct flashbvh_cursor {
  uint16_t a; /**< a node of A */
  uint16_t b;
  uint16_t untested;               /**< pairs of triangles left in the pair of leaves */
  FLASHBVH_BYTE(QueryState) state; /**< internal */
  uint8_t has_witness; /**< of a distance: not 0 if `witness_a` and `witness_b` are triangles; 2:
                          internal */
  uint16_t witness_a;  /**< slot of the nearest triangle so far; before, a node */
  uint16_t witness_b;
} flashbvh_cursor;

/** The counts of a query since its start: the columns of the paper's tables. */
typedef struct flashbvh_stats {
  uint32_t visits;         /**< pairs of boxes tested ("iterations") */
  uint32_t overlaps;       /**< of these, pairs that were not rejected */
  uint32_t leaf_pairs;     /**< of these, pairs of leaves ("leaf overlaps") */
  uint32_t triangle_pairs; /**< pairs of triangles that intersect ("geometry overlaps") */
} flashbvh_stats;

/** The size of a baked mesh's tree: the input of time bounds. */
typedef struct flashbvh_tree_size {
  uint32_t depth;     /**< of the deepest leaf; 0 for a root that is a leaf */
  uint32_t arity;     /**< most children of a node */
  uint32_t leaf_size; /**< most triangles in a leaf */
  uint32_t leaf_count;
  uint32_t triangle_count;
} flashbvh_tree_size;

/** The most instructions of the parts of a run on one core, with GCC 12 at -O2. */
typedef struct flashbvh_run_costs {
  uint32_t start;         /**< once */
  uint32_t ascent;        /**< once for each level of both trees */
  uint32_t later_sibling; /**< each sibling after the node from which a walk continues */
  uint32_t leaf_triangle; /**< each triangle of a leaf after the first */
  uint32_t work;          /**< each unit of work */
} flashbvh_run_costs;
