// A closed mesh for any test: a torus round the z axis.
#pragma once

#include <cstdint>

#include "bake/mesh.hpp"

namespace flashbvh::test {

/// 2 * around * across triangles. `around`: segments of the ring; `across`: of the tube; each at
/// least 3. `ring` and `tube`: radii in cells; their sum is at most kMaxCoordinate.
bake::LatticeMesh torus(std::uint32_t around, std::uint32_t across, double ring, double tube);

}  // namespace flashbvh::test
