// The C++ objects inside the C interface's opaque structs.
//
// A struct's bytes are an array of unsigned char, so an object may be made in them, and a copy of
// the struct is a copy of the object: all are trivially copyable, and none points into itself but
// those that make_in_place() makes.
#ifndef FLASHBVH_C_OBJECTS_HPP
#define FLASHBVH_C_OBJECTS_HPP

#include <stddef.h>

#include "flashbvh/detail/arch/inline.hpp"
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

/// Which object lies in a struct.
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

/// An answer to yes or no, and its status.
template <class Answer>
flashbvh_status put_answer(const Answer& answer, bool* yes) {
  *yes = answer.yes;
  return c_status(answer.status);
}

/// The caller's numbers, row by row, as an array of C++.
template <class Array, class Number>
const Array& array_in(const Number* numbers) {
  return *reinterpret_cast<const Array*>(numbers);
}

}  // namespace flashbvh

[[gnu::returns_nonnull]] inline void* operator new(size_t /*size*/, flashbvh::Storage storage) {
  return storage.bytes;
}

namespace flashbvh {

/// An object that its caller does not copy.
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

/// Plain data that `give()` returns, made in its place: neither copied nor twice on the stack.
template <class Plain, class Give>
FLASHBVH_INLINE inline void put(Plain* plain, Give&& give) {
  new (Storage{reinterpret_cast<unsigned char*>(plain)}) Plain(give());
}

/// `made` is complete before the first byte of `pose` changes: they may be made of one another.
inline flashbvh_status put_pose(const Pose& made, flashbvh_pose* pose) {
  return c_status(make(pose, made).status());
}

}  // namespace flashbvh

/// Says in a source file which object lies in a struct.
#define FLASHBVH_HOLDS(Struct, Held)  \
  template <>                         \
  struct flashbvh::ObjectIn<Struct> { \
    using Type = Held;                \
  }

#endif
