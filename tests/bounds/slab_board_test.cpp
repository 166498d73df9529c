// Slabs: their extent, and the test of two slabs at once.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "flashbvh/detail/bounds/slab_simd.hpp"
#include "support/points.hpp"
#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

PackedVector vector(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {join_halves(static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)), z};
}

PackedVector any_vector(Random& random, std::int32_t most) {
  const std::int32_t x = random.between(-most, most);
  const std::int32_t y = random.between(-most, most);
  return vector(x, y, random.between(-most, most));
}

/// A random direction of 13 bits and a sign.
PackedVector any_direction(Random& random) {
  const std::int32_t most = random.below(4) == 0 ? 8191 : 1 << random.below(13);
  return any_vector(random, most);
}

Box any_box(Random& random, std::int32_t most) {
  const Vertex corner = any_vertex(random, most);
  return box_around(corner, any_vertex(random, most));
}

/// The slab of a translated triangle, for boxes of the other tree.
struct AnySlab {
  PackedVector direction;
  Extent extent;
  Point offset;
  Side side;
  Slab slab;

  AnySlab(Random& random, std::int32_t most)
      : direction(any_direction(random)), side(random.below(2) == 0 ? Side::a : Side::b) {
    const auto corner = [&] { return PackedVector::of(any_vertex(random, most)); };
    extent = PackedTriangle{corner(), corner(), corner()}.extent(direction);
    const auto shift = [&] { return random.between(-2 * most, 2 * most); };
    offset = {shift(), shift(), shift()};
    slab.begin(direction, extent);
    slab.translate(offset, side);
  }

  std::int64_t along(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return std::int64_t{direction.x()} * x + std::int64_t{direction.y()} * y +
           std::int64_t{direction.z} * z;
  }
  std::int64_t moved() const {
    return (side == Side::a ? -1 : 1) * along(offset.x, offset.y, offset.z);
  }
  /// -1 below the slab, 1 above it, 0 inside.
  std::int32_t side_of(const Vertex& v) const {
    const std::int64_t at = along(v.x, v.y, v.z) - moved();
    return at < extent.least ? -1 : at > extent.most ? 1 : 0;
  }
  /// Compares the bounds of the box and of the slab along the direction, in 64-bit integers.
  bool touches(const Box& box) const {
    const std::int32_t d[3] = {direction.x(), direction.y(), direction.z};
    const std::int32_t lower[3] = {box.lower.x, box.lower.y, box.lower.z};
    const std::int32_t upper[3] = {box.upper.x, box.upper.y, box.upper.z};
    std::int64_t least = 0;
    std::int64_t most = 0;
    for (int i = 0; i < 3; ++i) {
      least += std::int64_t{d[i]} * (d[i] > 0 ? lower[i] : upper[i]);
      most += std::int64_t{d[i]} * (d[i] > 0 ? upper[i] : lower[i]);
    }
    return most >= extent.least + moved() && least <= extent.most + moved();
  }
};

}  // namespace

TEST_CASE("a box touches a slab exactly when their bounds along it meet, and two as each of them") {
  std::uint32_t touching = 0;
  std::uint32_t missing = 0;
  for_rounds(20000, [&](Random& random, int) {
    const std::int32_t most = random.below(3) == 0 ? kMaxCoordinate : 4 << random.below(12);
    const AnySlab u(random, most);
    const AnySlab v(random, most);
    const Box box = any_box(random, most);
    const PackedBox packed = pack(box);
    REQUIRE(u.slab.may_touch(packed) == u.touches(box));
    const bool both = u.touches(box) && v.touches(box);
    REQUIRE(may_touch_both(u.slab, v.slab, packed) == both);
    ++(both ? touching : missing);
    Slab all;
    all.set_all();
    REQUIRE(may_touch_both(all, all, packed));
  });
  CHECK(touching > 2000);
  CHECK(missing > 2000);
}

TEST_CASE("a slab misses vertices exactly when all lie on one side of it") {
  std::uint32_t touching = 0;
  std::uint32_t missing = 0;
  for_rounds(20000, 2, [&](Random& random, int) {
    const std::int32_t most = random.below(3) == 0 ? kMaxCoordinate : 4 << random.below(12);
    const AnySlab any(random, most);
    Vertex vertices[9];
    std::uint16_t corners[9];
    const std::uint32_t count = 1 + random.below(9);
    bool below = true;
    bool above = true;
    for (std::uint32_t i = 0; i < 9; ++i) {
      vertices[i] = any_vertex(random, most);
      corners[i] = static_cast<std::uint16_t>(random.below(9));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::int32_t where = any.side_of(vertices[corners[i]]);
      below = below && where < 0;
      above = above && where > 0;
    }
    REQUIRE(any.slab.may_touch(vertices, corners, corners + count) == (!below && !above));
    ++(below || above ? missing : touching);
    Slab all;
    all.set_all();
    REQUIRE(all.may_touch(vertices, corners, corners + count));
  });
  CHECK(touching > 2000);
  CHECK(missing > 2000);
}

TEST_CASE("a scaled direction has 13 bits, those of the product, and its sign") {
  for_rounds(20000, 1, [&](Random& random, int) {
    const std::int32_t most = random.below(3) == 0 ? 32766 : 1 << random.below(15);
    const PackedVector u = any_vector(random, most);
    const PackedVector v = any_vector(random, most);
    const std::int64_t product[3] = {std::int64_t{u.y()} * v.z - std::int64_t{u.z} * v.y(),
                                     std::int64_t{u.z} * v.x() - std::int64_t{u.x()} * v.z,
                                     std::int64_t{u.x()} * v.y() - std::int64_t{u.y()} * v.x()};
    std::int64_t largest = 1;
    for (const std::int64_t component : product) {
      largest = std::max(largest, component < 0 ? -component - 1 : component);
    }
    PackedVector direction{};
    const bool some = product[0] != 0 || product[1] != 0 || product[2] != 0;
    REQUIRE(cross_direction(u, v, direction) == some);
    if (some) {
      int shift = 0;
      while ((largest << 1 << shift) < (std::int64_t{1} << 32)) {
        ++shift;
      }
      const std::int32_t got[3] = {direction.x(), direction.y(), direction.z};
      for (int i = 0; i < 3; ++i) {
        REQUIRE(got[i] == (product[i] * (std::int64_t{1} << shift)) >> 19);
      }
    }
  });
}
