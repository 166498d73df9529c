// The slabs of leaves, against brute force.
#include <numeric>

#include "bake/leaf_slabs.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

namespace {

constexpr std::int64_t kUnit = 1 << kSlabUnitBits;

/// Checks that a slab holds a leaf's triangles, and no more than its coarse numbers need.
void check_holds(const bake::LatticeMesh& mesh, const LeafSlabs& slabs, int which) {
  const auto& d = slabs.of[which];
  std::int64_t least = INT64_MAX;
  std::int64_t most = INT64_MIN;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Vertex& v = mesh.vertices[corner];
      const std::int64_t along = 64 * (std::int64_t{d.x} * v.x + d.y * v.y + d.z * v.z);
      least = std::min(least, along);
      most = std::max(most, along);
    }
  }
  const std::int64_t lower = slabs.least[which] * kUnit;
  const std::int64_t thickness = (d.thickness & 31) * kUnit << 2 * (d.thickness >> 5);
  CHECK((lower <= least && lower > least - kUnit));
  CHECK(lower + thickness >= most);
  CHECK(thickness <= (most - lower + kUnit) * 9 / 8 + 4 * kUnit);
}

bool has_direction(const LeafSlabs::Direction& d) {
  return d.x != 0 || d.y != 0 || d.z != 0;
}

}  // namespace

TEST_CASE("slabs hold all triangles of their leaf") {
  for_rounds(3000, 1, [](Random& random, int round) {
    const std::int32_t size = round % 3 == 0 ? 2 : round % 3 == 1 ? 300 : 16000;
    bake::LatticeMesh mesh = random_mesh(random, 1 + random.below(5), 383, size);
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    const LeafSlabs slabs = bake::leaf_slabs(mesh, all);
    check_holds(mesh, slabs, 0);
    check_holds(mesh, slabs, 1);  // zeros hold all
  });
}

TEST_CASE("a flat leaf's slab is its plane; a leaf without area has none") {
  bake::LatticeMesh mesh;
  mesh.vertices = {{0, 0, 9000}, {9000, 0, 0}, {0, 9000, 0}, {9000, 9000, -9000}};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
  const LeafSlabs flat = bake::leaf_slabs(mesh, {0, 1});
  CHECK((flat.of[0].x == 127 && flat.of[0].y == 127 && flat.of[0].z == 127));
  CHECK(flat.of[0].thickness <= 1);
  CHECK(has_direction(flat.of[1]));
  mesh.triangles = {{0, 1, 1}, {2, 2, 2}};
  const LeafSlabs none = bake::leaf_slabs(mesh, {0, 1});
  CHECK((!has_direction(none.of[0]) && !has_direction(none.of[1])));
}
