// A library on a board: two meshes, queries about them, in the order of the poses.
#pragma once

#include <stdint.h>

#include "units.hpp"

namespace compare {

class Library {
 public:
  virtual ~Library() = default;
  /// Not counted: trees are built here, of floats, and what was built before is freed.
  virtual void set_meshes(const flashbvh::Mesh& a, const flashbvh::Mesh& b) = 0;
  /// Not counted: makes the caller's form of the pose, integers or a matrix of floats. What a query
  /// makes of it is counted.
  virtual void set_pose(const flashbvh::Pose& pose) = 0;
  /// Pairs of triangles that intersect; with `first`, at most one.
  virtual uint32_t query(bool first) = 0;
};

Library& opcode();
Library& float_tree();

}  // namespace compare
