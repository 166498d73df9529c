/* flashbvh for C: deformable meshes and self-intersection. See deformable.hpp and self.hpp.
 *
 * A deformable mesh is a baked mesh whose nodes and vertices were copied into the caller's memory.
 * Move any vertices, refit, and query: each call takes its `mesh`, on either side and at any pose.
 *
 *     flashbvh_deformable cloth;
 *     flashbvh_deformable_make(&cloth, &baked, nodes, vertices);
 *     vertices[7].z -= 12;
 *     status = flashbvh_deformable_refit(&cloth, UINT32_MAX, &vertex);
 *
 * A query begun before a refit must not run after it, nor may a cursor be resumed: store
 * flashbvh_deformable_refits() with them and compare. A self query detects a refit itself.
 *
 * Stack on a Cortex-M4 at -O2 (proofs/stack): a refit 176 bytes, a self query's run 504, the band
 * 720. */
#ifndef FLASHBVH_DEFORMABLE_H
#define FLASHBVH_DEFORMABLE_H

#include "flashbvh/flashbvh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Node of a tree; internal. 16 bytes. */
typedef struct flashbvh_node {
  uint32_t opaque[4];
} flashbvh_node;

/** DeformableMesh. Must not move while queries use it. 104 bytes on a 32-bit core, 144 on a 64-bit
 * one. */
typedef struct flashbvh_deformable {
  flashbvh_mesh mesh; /**< for queries */
  union {
    unsigned char bytes[3 * sizeof(void*) + 28];
    uint32_t word;
    void* pointer;
  } opaque;
} flashbvh_deformable;

/** Mesh::node_count. */
FLASHBVH_NODISCARD uint32_t flashbvh_mesh_nodes(const flashbvh_mesh* mesh);
/** Mesh::vertex_count. */
FLASHBVH_NODISCARD uint32_t flashbvh_mesh_vertices(const flashbvh_mesh* mesh);

/** Copies all nodes and vertices of `baked`. These arrays, and the arrays or the image of `baked`,
 * must outlive the mesh. */
void flashbvh_deformable_make(flashbvh_deformable* deformable, const flashbvh_mesh* baked,
                              flashbvh_node* nodes, flashbvh_vertex* vertices);

/** DeformableMesh::refit(); `work`: number of nodes, UINT32_MAX: no limit. DONE; SUSPENDED: call
 * again. VERTEX_OUT_OF_LATTICE, which alone writes `vertex`: move that vertex back and refit. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_deformable_refit(flashbvh_deformable* deformable,
                                                             uint32_t work, uint32_t* vertex);

/** DeformableMesh::refits(): odd while a refit is not done; different after each refit. */
FLASHBVH_NODISCARD uint32_t flashbvh_deformable_refits(const flashbvh_deformable* deformable);

/** DeformableQuery<SelfQuery>. 140 bytes on a 32-bit core, 176 on a 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_self_query, 9, 104, uint32_t);

/** A self query's cursor between runs; rejected after the mesh was refit. */
typedef struct flashbvh_self_cursor {
  flashbvh_cursor at;
  uint32_t refits;
} flashbvh_self_cursor;

/** Starts a query; the mesh must outlive it. SUSPENDED, or MESH_CHANGED during a refit. */
flashbvh_status flashbvh_self_query_start(flashbvh_self_query* query,
                                          const flashbvh_deformable* deformable);

/** As flashbvh_query_run(); MESH_CHANGED after the mesh was refit. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_self_query_run(flashbvh_self_query* query,
                                                               uint32_t work, flashbvh_pair* pairs,
                                                               uint32_t capacity);

/** As flashbvh_query_stats(). */
flashbvh_stats flashbvh_self_query_stats(const flashbvh_self_query* query);

/** As flashbvh_query_cursor(). */
flashbvh_self_cursor flashbvh_self_query_cursor(const flashbvh_self_query* query);

/** As flashbvh_query_resume(); MESH_CHANGED: the cursor is from before a refit. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_self_query_resume(flashbvh_self_query* query,
                                                              const flashbvh_self_cursor* cursor);

/** DeformableQuery<SelfWithinQuery>: pairs within a distance. 148 bytes on a 32-bit core, 184 on a
 * 64-bit one. */
FLASHBVH_OPAQUE(flashbvh_self_within_query, 9, 112, uint32_t);

/** Starts a query. DISTANCE_OUT_OF_RANGE; else as flashbvh_self_query_start(). */
flashbvh_status flashbvh_self_within_start(flashbvh_self_within_query* query,
                                           const flashbvh_deformable* deformable,
                                           flashbvh_fine_length distance);

/** As the functions of a self query. */
FLASHBVH_NODISCARD flashbvh_run_result flashbvh_self_within_run(flashbvh_self_within_query* query,
                                                                uint32_t work, flashbvh_pair* pairs,
                                                                uint32_t capacity);
flashbvh_stats flashbvh_self_within_stats(const flashbvh_self_within_query* query);
flashbvh_self_cursor flashbvh_self_within_cursor(const flashbvh_self_within_query* query);
FLASHBVH_NODISCARD flashbvh_status flashbvh_self_within_resume(flashbvh_self_within_query* query,
                                                               const flashbvh_self_cursor* cursor);

/** intersects_itself(), for any mesh. After an error `yes` is true. */
FLASHBVH_NODISCARD flashbvh_status flashbvh_intersects_itself(const flashbvh_mesh* mesh, bool* yes);

#ifdef __cplusplus
}
#endif

#endif
