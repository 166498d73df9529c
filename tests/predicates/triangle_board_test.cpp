// The triangle test against known answers, its own symmetries and, on the host, an oracle that
// proves each answer.
#include "flashbvh/detail/predicates/triangle.hpp"

#include <stddef.h>
#include <stdint.h>

#include <initializer_list>

#include "support/oracles/triangle.hpp"
#include "support/rounds.hpp"
#include "support/triangle_pairs.hpp"

namespace flashbvh::test {
namespace {

/// Whether all 36 orders of corners, each with both orders of arguments, give the expected answer.
bool all_orders_answer(bool expected, const Triangle& a, const Triangle& b) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Triangle p = ordered(a, i);
      const Triangle q = ordered(b, j);
      if (detail::triangles_intersect(p, q) != expected ||
          detail::triangles_intersect(q, p) != expected) {
        return false;
      }
    }
  }
  return true;
}

Triangle rotated(const Triangle& t) {
  const Point* const c = t.corner;
  return {{{c[0].y, c[0].z, c[0].x}, {c[1].y, c[1].z, c[1].x}, {c[2].y, c[2].z, c[2].x}}};
}

struct Case {
  const char* name;
  Triangle a;
  Triangle b;
};

constexpr Triangle kFloor = {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}};
constexpr Triangle kSegment = {{{0, 0, 0}, {4, 4, 4}, {8, 8, 8}}};
constexpr Triangle kPoint = {{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}};

/// contact_board_test.cpp has triangles that intersect.
constexpr Case kDisjoint[] = {
    {"planes cross, intervals disjoint", kFloor, {{{5, 5, -3}, {5, 5, 3}, {9, 9, 3}}}},
    {"intervals one cell apart", kFloor, {{{-1, 2, -3}, {-1, 2, 3}, {-4, 3, 0}}}},
    {"all above the plane", kFloor, {{{2, 2, 1}, {3, 2, 1}, {2, 3, 2}}}},
    {"parallel planes one cell apart", kFloor, {{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}}},
    {"boxes disjoint", kFloor, {{{9, 9, 9}, {10, 9, 9}, {9, 10, 9}}}},
    {"ends of 32 bits apart",
     {{{INT32_MIN, 0, 0}, {INT32_MIN, 1, 0}, {INT32_MIN, 0, 1}}},
     {{{INT32_MAX, 0, 0}, {INT32_MAX, 1, 0}, {INT32_MAX, 0, 1}}}},
    {"vertex next to edge", kFloor, {{{4, 5, 0}, {5, 5, 3}, {5, 6, 5}}}},
    {"vertex above face", kFloor, {{{2, 2, 1}, {2, 3, 3}, {3, 2, 5}}}},
    {"edge next to edge", kFloor, {{{4, 5, -1}, {4, 5, 1}, {7, 7, 0}}}},
    {"edge in the plane, disjoint", kFloor, {{{4, 5, 0}, {5, 4, 0}, {4, 4, 4}}}},
    {"edge continues an edge after a gap", kFloor, {{{9, 0, 0}, {12, 0, 0}, {9, -3, 4}}}},
    {"edge against edge, disjoint", kFloor, {{{4, 5, 0}, {9, 5, 0}, {5, 4, 0}}}},
    {"boxes overlap, disjoint", kFloor, {{{7, 7, 0}, {7, 3, 0}, {3, 7, 0}}}},
    {"on a slanted plane, disjoint",
     {{{4, 0, 0}, {0, 4, 0}, {0, 0, 4}}},
     {{{3, 2, -1}, {4, 2, -2}, {2, 4, -2}}}},
    {"point next to point", kPoint, {{{2, 2, 3}, {2, 2, 3}, {2, 2, 3}}}},
    {"point on the line beyond a segment", kPoint, {{{3, 3, 3}, {8, 8, 8}, {5, 5, 5}}}},
    {"point next to segment", {{{2, 2, 3}, {2, 2, 3}, {2, 2, 3}}}, kSegment},
    {"point next to face", kPoint, {{{0, 0, 1}, {8, 0, 1}, {0, 8, 4}}}},
    {"point in the plane, outside", kPoint, {{{3, 2, 2}, {2, 3, 2}, {9, 9, 2}}}},
    {"collinear segments disjoint", kSegment, {{{9, 9, 9}, {11, 11, 11}, {12, 12, 12}}}},
    {"parallel segments", kSegment, {{{0, 0, 1}, {4, 4, 5}, {8, 8, 9}}}},
    {"segments in one plane, disjoint", kSegment, {{{4, 3, 3}, {8, 3, 3}, {6, 3, 3}}}},
    {"skew, all projections cross", kSegment, {{{0, 8, 5}, {4, 4, 5}, {8, 0, 5}}}},
    {"segment misses face", kFloor, {{{5, 4, -4}, {5, 4, 4}, {5, 4, 2}}}},
    {"segment ends above face", kFloor, {{{2, 2, 1}, {2, 2, 4}, {2, 2, 2}}}},
    {"segment in the plane, disjoint", kFloor, {{{9, 0, 0}, {0, 9, 0}, {4, 5, 0}}}},
    {"on the line of an edge, disjoint", kFloor, {{{9, 0, 0}, {12, 0, 0}, {10, 0, 0}}}},
};

constexpr int32_t kSizes[] = {1, 2, 3, 5, 24, 1000, 32767, 32768, 65535, detail::kMaxDifference};

/// A pair of any kind.
TransformedPair random_pair(Random& random) {
  const int32_t size = random.one_of(kSizes);
  const uint32_t kind = random.below(6);
  TransformedPair pair = {triangle_within(random, size), triangle_within(random, size)};
  if (kind == 0) {
    return coplanar_pair(random, size);
  }
  if (kind == 1 && size >= 24) {
    return touching_pair(random, size);
  }
  if (kind <= 3) {  // a common corner
    pair.b.corner[0] = pair.a.corner[0];
  }
  if (kind == 3) {
    pair.b.corner[1] = pair.a.corner[1];
  }
  return pair;
}

/// The pair with its lowest coordinates (highest if `up`) at the end of 32 bits.
TransformedPair at_the_end(const TransformedPair& pair, bool up) {
  Point end = pair.a.corner[0];
  for (int32_t Point::*axis : kPointAxes) {
    for (const Triangle* t : {&pair.a, &pair.b}) {
      for (const Point& corner : t->corner) {
        end.*axis = (corner.*axis > end.*axis) == up ? corner.*axis : end.*axis;
      }
    }
  }
  const int32_t limit = up ? INT32_MAX : INT32_MIN;
  const Point to_zero = scaled(-1, end);
  const Point to_end = {limit, limit, limit};
  return {shifted(shifted(pair.a, to_zero), to_end), shifted(shifted(pair.b, to_zero), to_end)};
}

constexpr uint32_t kSymmetryPairs = 4000 / share_on_board(10);

}  // namespace

TEST_CASE("triangles that just miss each other are disjoint") {
  for (const Case& c : kDisjoint) {
    INFO(c.name);
    CHECK(all_orders_answer(false, c.a, c.b));
    CHECK(all_orders_answer(false, rotated(c.a), rotated(c.b)));
    CHECK(all_orders_answer(false, rotated(rotated(c.a)), rotated(rotated(c.b))));
  }
}

TEST_CASE("the order of corners and of arguments changes nothing") {
  for_rounds(kSymmetryPairs, [&](Random& random, uint32_t) {
    const TransformedPair pair = random_pair(random);
    REQUIRE(all_orders_answer(detail::triangles_intersect(pair.a, pair.b), pair.a, pair.b));
  });
}

TEST_CASE("the place changes nothing, at either end of 32 bits") {
  for_rounds(4 * kSymmetryPairs, [&](Random& random, uint32_t) {
    const TransformedPair pair = random_pair(random);
    const bool here = detail::triangles_intersect(pair.a, pair.b);
    for (const bool up : {false, true}) {
      const TransformedPair there = at_the_end(pair, up);
      CAPTURE(up);
      REQUIRE(detail::triangles_intersect(there.a, there.b) == here);
    }
  });
}

#if defined(__SIZEOF_INT128__)

namespace {

/// Whether the library gives the answer that the oracle proves.
bool agrees(const Triangle& a, const Triangle& b) {
  const Verdict verdict = decide(a, b);
  return is_proven(verdict, a, b) && detail::triangles_intersect(a, b) == verdict.intersects;
}

}  // namespace

TEST_CASE("every pair of triangles in the unit cube agrees with the oracle") {
  uint32_t wrong = 0;
  const auto triangle = [](uint32_t code) {
    const auto corner = [](uint32_t bits) {
      return Point{static_cast<int32_t>(bits & 1), static_cast<int32_t>(bits >> 1 & 1),
                   static_cast<int32_t>(bits >> 2 & 1)};
    };
    return Triangle{{corner(code), corner(code >> 3), corner(code >> 6)}};
  };
  for (uint32_t i = 0; i < 512; ++i) {
    for (uint32_t j = i; j < 512; ++j) {
      wrong += agrees(triangle(i), triangle(j)) ? 0u : 1u;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("small triangles agree with the oracle") {
  for_rounds(rounds(60000u, 400000u), [&](Random& random, uint32_t) {
    const int32_t size = random.between(2, 3);
    const TransformedPair pair = {triangle_within(random, size), triangle_within(random, size)};
    REQUIRE(agrees(pair.a, pair.b));
  });
}

TEST_CASE("triangles of every kind and size agree with the oracle") {
  for_rounds(rounds(60000u, 400000u), [&](Random& random, uint32_t) {
    TransformedPair pair = random_pair(random);
    // A shift of every other pair by one cell makes touching pairs nearly touching.
    int32_t Point::*const axis = random.below(2) != 0 ? &Point::x : &Point::z;
    Point& corner = pair.b.corner[random.below(3)];
    corner.*axis -= random.below(2) != 0 && corner.*axis > 0 ? 1 : 0;
    REQUIRE(agrees(pair.a, pair.b));
  });
}

#endif  // __SIZEOF_INT128__

}  // namespace flashbvh::test
