// The C++ objects inside the C interface's opaque structs.
//
// A struct's bytes are an array of unsigned char, so an object may be constructed in them. A copy
// of the struct is a copy of the object: all objects are trivially copyable. Only objects that
// make_in_place() makes may point into themselves.
#pragma once

#include <stddef.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/flashbvh.h"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// Memory for placement `new`. Defined here because not every firmware's compiler has <new>.
struct Storage {
  unsigned char* bytes;
};

/// Maps a C struct to the type of the object in it.
template <class Struct>
struct ObjectIn;
template <>
struct ObjectIn<flashbvh_mesh> {
  using Type = Mesh;
};
template <>
struct ObjectIn<flashbvh_pose> {
  using Type = Pose;
};
template <>
struct ObjectIn<flashbvh_query> {
  using Type = PairQuery;
};
template <class Struct>
using Object = typename ObjectIn<Struct>::Type;

template <class Struct>
Object<Struct>& object_in(Struct* object) {
  return *reinterpret_cast<Object<Struct>*>(object);
}
template <class Struct>
const Object<Struct>& object_in(const Struct* object) {
  return *reinterpret_cast<const Object<Struct>*>(object);
}

inline flashbvh_status c_status(Status status) {
  return static_cast<flashbvh_status>(status);
}

/// Stores a yes-or-no answer and returns its status.
template <class Answer>
flashbvh_status put_answer(const Answer& answer, bool* yes) {
  *yes = answer.yes;
  return c_status(answer.status);
}

/// Views the caller's numbers, row by row, as a C++ array.
template <class Array, class Number>
const Array& array_in(const Number* numbers) {
  return *reinterpret_cast<const Array*>(numbers);
}

}  // namespace flashbvh

[[gnu::returns_nonnull]] inline void* operator new(size_t /*size*/, flashbvh::Storage storage) {
  return storage.bytes;
}

namespace flashbvh {

/// Constructs an object in a struct that the caller must not copy.
template <class Struct, class... Arguments>
FLASHBVH_INLINE inline Object<Struct>& make_in_place(Struct* object, const Arguments&... with) {
  static_assert(sizeof(Object<Struct>) <= sizeof(Struct), "the struct is too small");
  static_assert(alignof(Object<Struct>) <= alignof(Struct), "the struct is not aligned");
  static_assert(__has_trivial_destructor(Object<Struct>), "C drops its structs as bytes");
  return *new (Storage{reinterpret_cast<unsigned char*>(object)}) Object<Struct>(with...);
}

template <class Struct, class... Arguments>
FLASHBVH_INLINE inline Object<Struct>& make(Struct* object, const Arguments&... with) {
  static_assert(__is_trivially_copyable(Object<Struct>), "C copies its structs as bytes");
  return make_in_place(object, with...);
}

/// Constructs the result of `give()` in place, without a copy on the stack.
template <class Plain, class Give>
FLASHBVH_INLINE inline void put(Plain* plain, Give&& give) {
  new (Storage{reinterpret_cast<unsigned char*>(plain)}) Plain(give());
}

/// `made` is complete before the first byte of `pose` changes, so it may be computed from `pose`.
inline flashbvh_status put_pose(const Pose& made, flashbvh_pose* pose) {
  return c_status(make(pose, made).status());
}

}  // namespace flashbvh

/// Declares in a source file which object lies in a struct.
#define FLASHBVH_HOLDS(Struct, Held)  \
  template <>                         \
  struct flashbvh::ObjectIn<Struct> { \
    using Type = Held;                \
  }
