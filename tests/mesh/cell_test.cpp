// The finest cell: the mesh fits, and fills the lattice up to a rounding.
#include "bake/quantise.hpp"
#include "flashbvh/image.hpp"
#include "support/test.hpp"

namespace {

constexpr double kWidth = 2.0 * kMaxCoordinate;

/// A triangle from `low` to `high` along x.
bake::SourceMesh mesh_between(double low, double high) {
  return {{{low, 0, 0}, {high, 0, 0}, {low, (high - low) / 3, 0}}, {{0, 1, 2}}};
}

}  // namespace

TEST_CASE("a mesh fits its finest cell, which its width fills but for what rounding takes") {
  for_rounds(20000, [&](Random& random, int i) {
    // Whole and half numbers often put both ends halfway between cells.
    const double width = i % 2 == 0 ? kWidth : 100 + random.below(1000);
    const double low = (static_cast<double>(random.below(2000001)) - 1e6) / (i % 3 == 0 ? 2 : 64);
    const bake::SourceMesh mesh = mesh_between(low, low + width);
    const double cell = bake::finest_cell(bake::extent_of(mesh));
    CAPTURE(low, width, cell);
    REQUIRE(bake::fits(bake::extent_of(mesh), cell));
    REQUIRE(cell <= width / (kWidth - 1) * (1 + 1e-9));
    REQUIRE(cell >= width / kWidth);
  });
}

TEST_CASE("the whole width of the lattice is used where rounding allows it") {
  CHECK(bake::finest_cell(bake::extent_of(mesh_between(0, kWidth))) == 1);
  CHECK(bake::finest_cell(bake::extent_of(mesh_between(-26, 26))) == 52 / kWidth);
  // Both ends are halfway between cells and round away from each other.
  const bake::SourceMesh halves = mesh_between(-0.5, kWidth - 0.5);
  CHECK(!bake::fits(bake::extent_of(halves), 1));
  CHECK(bake::finest_cell(bake::extent_of(halves)) <= 1 + 1e-14);
}
