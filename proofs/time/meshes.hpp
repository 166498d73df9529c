// Small meshes that cost a query as much as can be: boxes that all overlap, triangles that fall
// through to the rare branches of the exact test, trees as deep as they get.
#ifndef FLASHBVH_TESTS_BOUND_MESHES_HPP
#define FLASHBVH_TESTS_BOUND_MESHES_HPP

#include <stdint.h>

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

/// `reach`: of the coordinates, at most flashbvh::kMaxCoordinate.
void make_mesh(flashbvh::test::Random& random, Kind kind, int32_t reach, digest::SmallMesh& mesh);

}  // namespace bound

#endif
