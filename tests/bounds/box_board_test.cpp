// Packed boxes and the overlap test, against plain integers.
#include <cstdint>
#include <initializer_list>

#include "flashbvh/detail/bounds/box.hpp"
#include "support/points.hpp"
#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// The largest translation of a box: a pose's and both origins, each up to 2^29.
constexpr std::int32_t kMostTranslation = 3 << 29;

std::int32_t translation(Random& random) {
  constexpr std::int32_t ends[] = {0, 1, -1, 32765, 32766, 32767, 32768, 32769, 65535, 65536};
  const std::int32_t end = random.one_of(ends);
  switch (random.below(4)) {
    case 0:
      return end;
    case 1:
      return -end;
    case 2:
      return random.between(-40000, 40000);
    default:
      const auto far = kMostTranslation - static_cast<std::int32_t>(random.below(3));
      return random.below(2) == 0 ? -far : far;
  }
}

}  // namespace

TEST_CASE("packing a box loses nothing") {
  for_rounds(10000, [&](Random& random, int) {
    const Box original = any_box(random);
    const PackedBox packed = pack(original);
    const Box back = unpack(packed);
    REQUIRE(same(back, original));
    REQUIRE(extent_x(packed) == static_cast<std::uint32_t>(original.upper.x - original.lower.x));
    REQUIRE(extent_y(packed) == static_cast<std::uint32_t>(original.upper.y - original.lower.y));
    REQUIRE(extent_z(packed) == static_cast<std::uint32_t>(original.upper.z - original.lower.z));
  });
}

TEST_CASE("packed boxes overlap exactly when the boxes do, at every translation") {
  int overlaps = 0;
  for_rounds(100000, [&](Random& random, int) {
    const Box a = any_box(random);
    const Box b = any_box(random);
    const auto along = [&] { return random.below(2) == 0 ? 0 : translation(random); };
    const Point by = {along(), along(), along()};
    const bool expected = overlap(a, b, by);
    overlaps += expected ? 1 : 0;
    const TranslatedBoxTest test(by.x, by.y, by.z);
    const BoxInNode of_a = in_node(random, a);
    const BoxInNode of_b = in_node(random, b);
    REQUIRE(test(of_a.box, of_b.box) == expected);
    REQUIRE(test.portable(of_a.box, of_b.box) == expected);
    const auto by_axis = [&](int axis) { return by.*kPointAxes[axis]; };
    REQUIRE(boxes_disjoint(of_a.box, of_b.box, by_axis) == !expected);
  });
  CHECK(overlaps > 1000);
}

TEST_CASE("all forms of the packed comparison are one function") {
  for_rounds(100000, [&](Random& random, int) {
    const auto half = [&] {
      constexpr std::uint32_t ends[] = {0, 1, 0x7FFF, 0x8000, 0x8001, 0xFFFE, 0xFFFF};
      return random.below(2) == 0 ? random.one_of(ends) : random.below(0x10000);
    };
    const auto word = [&] {
      const std::uint32_t low = half();
      return join_halves(low, half());
    };
    PackedTriple value{};
    PackedTriple least{};
    for (int i = 0; i < 3; ++i) {
      value.word[i] = word();
      least.word[i] = random.below(2) == 0 ? value.word[i] : word();
    }
    const bool reference = halves_reach_portable(value, least);
    REQUIRE(halves_reach_plain(value, least) == reference);
    REQUIRE(halves_reach(value, least) == reference);
  });
}
