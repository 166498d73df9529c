// A library on a board: two meshes and their queries, in the order of the poses.
#pragma once

#include <stdint.h>

#include "units.hpp"

namespace compare {

class Library {
 public:
  virtual ~Library() = default;
  /// Frees the last trees and builds new ones from floats. Not counted.
  virtual void set_meshes(const flashbvh::Mesh& a, const flashbvh::Mesh& b) = 0;
  /// Makes the caller's form of the pose, integers or a matrix of floats. Not counted; conversions
  /// within the query are counted.
  virtual void set_pose(const flashbvh::Pose& pose) = 0;
  /// Pairs of triangles that intersect; with `first`, at most one.
  virtual uint32_t query(bool first) = 0;
};

Library& opcode();
Library& float_tree();

}  // namespace compare
