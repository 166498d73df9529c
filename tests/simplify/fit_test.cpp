// Meshes that fit flash: by the least length that suffices.
#include "simplify/fit.hpp"

#include "bake/quantise.hpp"
#include "simplify/zoo.hpp"

using namespace flashbvh::test;
using simplify::Coarsening;
using simplify::Fit;

namespace {

/// Smaller leaves need more bytes.
double bytes_of(const std::vector<Coarsening>& meshes, std::uint32_t leaf_size) {
  std::size_t triangles = 0;
  for (const Coarsening& mesh : meshes) {
    triangles += mesh.mesh().triangles.size();
  }
  return static_cast<double>(triangles) * (leaf_size == 2 ? 24 : 16);
}

struct Meshes {
  std::vector<bake::SourceMesh> sources = {wavy_ring(30, 10, 0.3), hills(16, 12)};
  std::vector<Coarsening> all() const {
    std::vector<Coarsening> meshes;
    for (const bake::SourceMesh& source : sources) {
      meshes.emplace_back(source, finest_cell_of(source));
    }
    return meshes;
  }
};

}  // namespace

TEST_CASE("what fits as it is stays as it is, in the smallest leaves that do") {
  const Meshes meshes;
  std::vector<Coarsening> all = meshes.all();
  const double full = bytes_of(all, 2);
  const auto small = simplify::fit(all, full, 5, {2, 5}, bytes_of);
  REQUIRE(small);
  CHECK(small->length == 0);
  CHECK(small->leaf_size == 2);
  const auto large = simplify::fit(all, full - 1, 5, {2, 5}, bytes_of);
  REQUIRE(large);
  CHECK(large->length == 0);
  CHECK(large->leaf_size == 5);
  CHECK(bytes_of(all, 2) == full);
}

TEST_CASE("meshes become as much coarser as it takes, and no more") {
  const Meshes meshes;
  for (const double part : {0.5, 0.2}) {
    CAPTURE(part);
    std::vector<Coarsening> all = meshes.all();
    const double most = part * bytes_of(all, 5);
    const auto found = simplify::fit(all, most, 20, {2, 5}, bytes_of);
    REQUIRE(found);
    CHECK(found->length > 0);
    CHECK(bytes_of(all, found->leaf_size) <= most);
    for (const Coarsening& mesh : all) {
      CHECK(mesh.deviation().most <= found->length);
    }
    // A length shorter by two steps, applied directly, does not suffice.
    std::vector<Coarsening> finer = meshes.all();
    simplify::coarsen_all(finer, found->length / 1.3);
    CHECK(bytes_of(finer, 5) > most * 0.97);
  }
}

TEST_CASE("a little longer a length is worth smaller leaves, much longer is not") {
  const Meshes meshes;
  for (const double large : {23.0, 12.0}) {
    CAPTURE(large);
    std::vector<Coarsening> all = meshes.all();
    const auto bytes = [&](const std::vector<Coarsening>& coarse, std::uint32_t leaf_size) {
      return bytes_of(coarse, 2) * (leaf_size == 2 ? 1 : large / 24);
    };
    const auto found = simplify::fit(all, 0.3 * bytes(all, 2), 20, {2, 5}, bytes);
    REQUIRE(found);
    CHECK(found->leaf_size == (large > 20 ? 2 : 5));
    CHECK(bytes(all, found->leaf_size) <= 0.3 * bytes(meshes.all(), 2));
  }
}
