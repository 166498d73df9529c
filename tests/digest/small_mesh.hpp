// Random meshes in fixed arrays, and poses that move them against each other.
#pragma once

#include <stdint.h>

#include "small_tree.hpp"
#include "support/rotations.hpp"

namespace digest {

/// The size of a mesh, in cells, and the largest translation of poses.
struct Scale {
  int32_t spread;
  int32_t size;
  int32_t reach;
};
constexpr Scale kScales[] = {
    {3, 2, 2}, {40, 30, 30}, {900, 500, 700}, {16383, 9000, 12000}, {16383, 32766, 30000}};

/// Some triangles share an edge with the previous one; some have no area, some occur twice.
void make_mesh(flashbvh::test::Random& random, const Scale& scale, SmallMesh& mesh);

/// A random pose, sometimes a translation.
flashbvh::Pose any_pose(flashbvh::test::Random& random, const Scale& scale);

}  // namespace digest
