// Random meshes in fixed arrays and poses that translate them against each other.
#pragma once

#include <stdint.h>

#include "small_tree.hpp"
#include "support/rotations.hpp"

namespace digest {

/// How large a mesh is, in cells, and how far poses translate it.
struct Scale {
  int32_t spread;
  int32_t size;
  int32_t reach;
};
constexpr Scale kScales[] = {
    {3, 2, 2}, {40, 30, 30}, {900, 500, 700}, {16383, 9000, 12000}, {16383, 32766, 30000}};

/// Triangles that share an edge with the one before, now and then; some without area, some twice.
void make_mesh(flashbvh::test::Random& random, const Scale& scale, SmallMesh& mesh);

/// Now and then a translation.
flashbvh::Pose any_pose(flashbvh::test::Random& random, const Scale& scale);

}  // namespace digest
