// aimed_rays [COUNT]: casts COUNT rays, 100,000 by default, at edges and corners of closed meshes;
// exits with 0 if none is lost.
#include <cstdlib>
#include <iostream>

#include "query/aimed_rays.hpp"
#include "support/any_mesh.hpp"
#include "support/torus.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100'000;
  const bake::LatticeMesh meshes[] = {torus(24, 16, 8000, 3000), torus(150, 60, 9000, 4000),
                                      torus(7, 5, 30, 11), torus(40, 20, 12'000, 4'000)};
  Random random = test_random();
  std::uint64_t lost = 0;
  for (const bake::LatticeMesh& lattice : meshes) {
    const AnyMesh mesh(bake::build_default(lattice), lattice);
    const AimedRays rays(mesh);
    for (std::uint64_t i = 0; i < count / 4; ++i) {
      lost += rays.is_right(random) ? 0 : 1;
    }
  }
  std::cout << lost << " of " << count / 4 * 4 << " rays lost\n";
  return lost == 0 ? 0 : 1;
}
