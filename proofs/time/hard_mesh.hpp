// Small meshes that cost a query as much as can be: boxes that all overlap, triangles that fall
// through to the rare branches of the exact tests, trees as deep as they get.
#pragma once

#include "digest/small_tree.hpp"
#include "support/random.hpp"

namespace bound {

enum class Kind : uint8_t {
  scattered,  ///< small triangles anywhere
  crowded,    ///< large ones through one region: all boxes overlap
  flat,       ///< all in one plane
  segments,   ///< without area, on one line or not
  points,     ///< all corners of a triangle in one place
};
constexpr uint32_t kKinds = 5;

/// A mesh and its tree.
struct Side {
  digest::SmallMesh mesh;
  digest::SmallTree<flashbvh::Layout::post_indexed> tree;
  uint32_t leaf_size;
  uint32_t depth;
};

/// Of any kind, with leaves of one to three triangles. `reach`: of the coordinates, at most
/// kMaxCoordinate. False if the tree is none.
bool make_side(flashbvh::test::Random& random, int32_t reach, Side& side);

}  // namespace bound
