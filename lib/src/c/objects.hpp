// The C++ objects inside the C interface's plain structs.
//
// A struct's bytes are an array of unsigned char, so an object may be made in them, and a copy of
// the struct is a copy of the object: all are trivially copyable, and none points into itself.
#ifndef FLASHBVH_C_OBJECTS_HPP
#define FLASHBVH_C_OBJECTS_HPP

#include <stddef.h>

#include "flashbvh/flashbvh.h"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// Memory for `new`. Of our own: <new> is no header of the freestanding kind that C has, and every
/// firmware.
struct Storage {
  unsigned char* bytes;
};

template <class Object, class Struct>
Storage storage_of(Struct* object) {
  static_assert(sizeof(Object) <= sizeof(Struct), "the struct in flashbvh.h is too small");
  static_assert(alignof(Object) <= alignof(Struct), "the struct in flashbvh.h is not aligned");
  static_assert(__is_trivially_copyable(Object), "C copies and drops its structs as bytes");
  return {object->opaque.bytes};
}

inline const PostMesh& object_in(const flashbvh_mesh* mesh) {
  return *reinterpret_cast<const PostMesh*>(mesh->opaque.bytes);
}
inline const Pose& object_in(const flashbvh_pose* pose) {
  return *reinterpret_cast<const Pose*>(pose->opaque.bytes);
}
inline PairQuery& object_in(flashbvh_query* query) {
  return *reinterpret_cast<PairQuery*>(query->opaque.bytes);
}
inline const PairQuery& object_in(const flashbvh_query* query) {
  return *reinterpret_cast<const PairQuery*>(query->opaque.bytes);
}

inline flashbvh_status c_status(Status status) {
  return static_cast<flashbvh_status>(status);
}

inline flashbvh_pair c_pair(const PairQuery::Pair& pair) {
  return {pair.a, pair.b};
}

inline flashbvh_counts c_counts(const Counts& counts) {
  return {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
}

inline flashbvh_position c_position(const QueryPosition<uint16_t>& position) {
  return {
      position.a, position.b, position.untested, static_cast<uint8_t>(position.state), {0, 0, 0}};
}

inline void put(const Triangle& placed, flashbvh_triangle* triangle) {
  for (int i = 0; i < 3; ++i) {
    const Point& corner = placed.corner[i];
    triangle->corner[i] = {corner.x, corner.y, corner.z};
  }
}
inline Triangle triangle_of(const flashbvh_triangle& given) {
  const flashbvh_point* const c = given.corner;
  return {{{c[0].x, c[0].y, c[0].z}, {c[1].x, c[1].y, c[1].z}, {c[2].x, c[2].y, c[2].z}}};
}

/// A query's spend() into an array of C's.
template <class Query>
FLASHBVH_INLINE inline Status run_into(Query& query, uint32_t& work, flashbvh_pair* pairs,
                                       uint32_t capacity, uint32_t& count) {
  count = 0;
  if (capacity == 0 && query.status() == Status::suspended) {
    return Status::full;
  }
  uint32_t written = 0;
  const Status status = query.spend(
      work,
      [&](const typename Query::Pair& pair) {
        pairs[written++] = c_pair(pair);
        return written < capacity;
      },
      [&] { return capacity - written; });
  count = written;
  return status;
}

}  // namespace flashbvh

[[gnu::returns_nonnull]] inline void* operator new(size_t /*size*/, flashbvh::Storage storage) {
  return storage.bytes;
}

namespace flashbvh {

/// `made` is complete before the first byte of `pose` changes: they may be made of one another.
inline flashbvh_status put_pose(const Pose& made, flashbvh_pose* pose) {
  new (storage_of<Pose>(pose)) Pose(made);
  return c_status(made.status());
}

}  // namespace flashbvh

#endif
