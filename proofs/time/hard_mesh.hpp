// Small meshes that make queries as expensive as possible: all boxes overlap, triangles need the
// rare branches of the exact tests, and trees are as deep as possible.
#pragma once

#include "digest/small_tree.hpp"
#include "support/random.hpp"

namespace bound {

enum class Kind : uint8_t {
  scattered,  ///< small triangles anywhere
  crowded,    ///< large ones through one region: all boxes overlap
  flat,       ///< all in one plane
  segments,   ///< without area, on one line or not
  points,     ///< all corners of a triangle in one point
};
constexpr uint32_t kKinds = 5;

/// A mesh and its tree.
struct Side {
  digest::SmallMesh mesh;
  digest::SmallTree<flashbvh::Layout::post_indexed> tree;
  uint32_t leaf_size;
  uint32_t depth;
};

/// Makes a mesh of any kind, with leaves of one to three triangles. `reach`: the limit of
/// coordinates, at most kMaxCoordinate. False if the tree is invalid.
bool make_side(flashbvh::test::Random& random, int32_t reach, Side& side);

}  // namespace bound
