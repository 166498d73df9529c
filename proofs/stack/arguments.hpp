// The arguments of an entry, under one signature for all of entries.inc, and their common includes.
//
// Linked alone, an entry gives its query's code size; it is the root of the query's call graph. The
// firmware of painted.cpp calls it through a pointer, so the painted depth is that of the call
// graph's machine code. The caller's memory for a query lies in Arguments: it is no stack.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/flashbvh.h"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/motion.hpp"
#include "flashbvh/robot/workcell.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/solid.hpp"
#include "flashbvh/traversal/traversals.hpp"

namespace stack_proof {

/// Storage for an object that an entry makes.
template <size_t size>
struct alignas(8) Room {
  unsigned char bytes[size];
};

template <class Object, size_t size>
Object& as(Room<size>& room) {
  return *reinterpret_cast<Object*>(room.bytes);
}

constexpr uint32_t kStackEntries = 64;

/// The number of links in robot_image.
constexpr uint32_t kRobotLinks = 6;

struct Arguments {
  const flashbvh::MeshWithLevels* a;
  const flashbvh::MeshWithLevels* b;
  const flashbvh::Mesh* closed;    ///< the mesh, marked closed
  flashbvh::DeformableMesh* bent;  ///< the mesh, with two of its triangles moved
  const flashbvh::PreMeshWithLevels* pre_a;
  const flashbvh::PreMeshWithLevels* pre_b;
  const flashbvh::Pose* pose;
  const flashbvh::Pose* other_pose;
  const flashbvh::Triangle* triangles;  ///< two
  const void* image;                    ///< post-indexed
  uint32_t image_size;
  const void* robot_image;
  uint32_t robot_image_size;
  flashbvh::Mesh* robot_meshes;  ///< storage for its views

  const int32_t (*rotation)[3];  ///< three rows
  const int32_t* cells;
  const int16_t* fraction;
  const float* rigid_floats;  ///< a matrix's nine, row by row, and a translation
  const float* floats;  ///< twelve: a matrix and a translation, or a quaternion and a translation

  const flashbvh_mesh* c_a;
  const flashbvh_mesh* c_b;
  const flashbvh_mesh* c_closed;  ///< the mesh, marked closed
  flashbvh_deformable* c_bent;    ///< the mesh, with two of its triangles moved
  const flashbvh_pose* c_pose;
  const flashbvh_pose* c_other_pose;

  const flashbvh::Robot* robot;  ///< one joint, a's mesh on either side of it
  flashbvh::GuardStateOf<1, 1, 1>* guard_state;
  flashbvh::MotionStateOf<1, 1>* motion_state;
  flashbvh::WorkcellOf<3, 4, 2, 5>* workcell_memory;

  uint32_t distance;  ///< of the query
  uint32_t work;      ///< of a run
  uint32_t capacity;  ///< of the array of pairs, in a run

  // Outputs.
  uint32_t answer;  ///< pairs found, or 0 and 1
  uint8_t status;
  flashbvh::RunResult step;  ///< of the last run
  flashbvh::PairQuery::Pair found[4];
  flashbvh::detail::PairCursor<uint16_t> stack[kStackEntries];
  Room<160> query;
  Room<192> motion;
  Room<68> made_pose;
  Room<80> opened;
  flashbvh::Triangle transformed[2];
  flashbvh::Contact contact;
  flashbvh_contact c_contact;
  int64_t millionths;
  flashbvh::QueryCursor<uint16_t> position;
  flashbvh::Clearance<uint16_t> clearance;
  flashbvh_cursor c_cursor;
  flashbvh_witness c_witness;
  flashbvh_clearance c_clearance;
  flashbvh_box_shape c_box;

  template <class Status>
  void ends(Status with) {
    status = static_cast<uint8_t>(with);
  }
  void takes(const flashbvh::Answer& answered) {
    answer = answered.yes ? 1 : 0;
    ends(answered.status);
  }
  void takes(const flashbvh::RunResult& counted) {
    answer = counted.count;
    ends(counted.status);
  }
  /// Counts all pairs of a query.
  template <class QueryType>
  [[gnu::always_inline]] void counts(QueryType& counted) {
    const auto count = [this](const typename QueryType::Pair&) {
      ++answer;
      return true;
    };
    ends(counted.run(UINT32_MAX, count).status);
  }

  flashbvh_pair* c_found() { return reinterpret_cast<flashbvh_pair*>(found); }
  flashbvh_pose* c_made() { return &as<flashbvh_pose>(made_pose); }
};

/// The floats from an index on, as a matrix or a vector.
template <class Array>
const Array& floats_as(const Arguments& in, int from) {
  return *reinterpret_cast<const Array*>(in.floats + from);
}

/// Constructs an object in place, like a caller's variable.
template <class Object, size_t size, class Make>
Object& make_in(Room<size>& room, const Make& make);

}  // namespace stack_proof

/// Freestanding C++ has no <new> on every core.
struct InPlace {
  void* bytes;
};
[[gnu::returns_nonnull]] inline void* operator new(size_t /*size*/, InPlace place) {
  return place.bytes;
}

template <class Object, size_t size, class Make>
Object& stack_proof::make_in(Room<size>& room, const Make& make) {
  static_assert(sizeof(Object) <= size && alignof(Object) <= 8, "the room is too small");
  return *new (InPlace{room.bytes}) Object(make());
}

extern "C" {
using EntryFunction = void(stack_proof::Arguments* in);
}
