// Contacts against known answers and against their own symmetries.
#include "flashbvh/contact.hpp"

#include <stdint.h>

#include <initializer_list>

#include "support/rounds.hpp"
#include "support/triangle_pairs.hpp"

namespace flashbvh::test {
namespace {

Normal opposite(const Normal& n) {
  return {-n.x, -n.y, -n.z};
}
/// The normal for an order of corners; the last three orders reverse the winding.
Normal wound(const Normal& n, int order) {
  return order < 3 ? n : opposite(n);
}

/// Whether all 36 orders of corners, each with both orders of arguments, give this contact.
bool all_orders_give(const Contact& expected, const Triangle& a, const Triangle& b) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      const Contact c = contact_of(ordered(a, i), ordered(b, j));
      const Contact d = contact_of(ordered(b, j), ordered(a, i));
      const Normal normal_a = wound(expected.normal_a, i);
      const Normal normal_b = wound(expected.normal_b, j);
      if (!same_place(c, expected) || !same_place(d, expected) || !same(c.normal_a, normal_a) ||
          !same(d.normal_b, normal_a) || !same(c.normal_b, normal_b) ||
          !same(d.normal_a, normal_b)) {
        return false;
      }
    }
  }
  return true;
}

struct Case {
  const char* name;
  Triangle a;
  Triangle b;
  FinePoint ends[2];  ///< of the intersection, in cells; for cases between cells, in 1/256 cell
};

constexpr Triangle kFloor = {{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}};
constexpr Triangle kRod = {{{0, 0, 0}, {4, 4, 4}, {8, 8, 8}}};
constexpr Triangle kDot = {{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}};

constexpr Case kCrossing[] = {
    {"across the face", kFloor, {{{2, -9, -3}, {2, -9, 9}, {2, 99, -3}}}, {{2, 0, 0}, {2, 6, 0}}},
    {"both ends inside", kFloor, {{{1, 2, -2}, {5, 2, -2}, {3, 2, 2}}}, {{2, 2, 0}, {4, 2, 0}}},
    {"pierce each other", kFloor, {{{2, 2, 2}, {2, 2, -2}, {-9, 2, 0}}}, {{0, 2, 0}, {2, 2, 0}}},
    {"vertex on vertex", kFloor, {{{8, 0, 0}, {9, 0, 3}, {9, 1, 5}}}, {{8, 0, 0}, {8, 0, 0}}},
    {"vertex on edge", kFloor, {{{4, 4, 0}, {5, 5, 3}, {5, 6, 5}}}, {{4, 4, 0}, {4, 4, 0}}},
    {"vertex on face", kFloor, {{{2, 2, 0}, {2, 3, 3}, {3, 2, 5}}}, {{2, 2, 0}, {2, 2, 0}}},
    {"edge crosses edge", kFloor, {{{4, 4, -1}, {4, 4, 1}, {7, 7, 0}}}, {{4, 4, 0}, {4, 4, 0}}},
    {"edge in the face", kFloor, {{{1, 1, 0}, {3, 3, 0}, {2, 2, 4}}}, {{1, 1, 0}, {3, 3, 0}}},
    {"edge across the face", kFloor, {{{-1, 1, 0}, {9, 1, 0}, {4, 1, 4}}}, {{0, 1, 0}, {7, 1, 0}}},
    {"edge along an edge", kFloor, {{{2, 0, 0}, {12, 0, 0}, {4, -3, 4}}}, {{2, 0, 0}, {8, 0, 0}}},
    {"continues an edge", kFloor, {{{8, 0, 0}, {12, 0, 0}, {9, -3, 4}}}, {{8, 0, 0}, {8, 0, 0}}},
    {"shared edge", kFloor, {{{0, 0, 0}, {8, 0, 0}, {0, 0, 8}}}, {{0, 0, 0}, {8, 0, 0}}},
};
constexpr Case kCrossingBetweenCells[] = {
    {"between cells", kFloor, {{{1, 1, -1}, {2, 2, 2}, {-7, 2, -1}}}, {{0, 384, 0}, {341, 341, 0}}},
};

constexpr Case kCoplanar[] = {
    {"the same triangle", kFloor, kFloor, {{0, 0, 0}, {8, 0, 0}}},
    {"nested", kFloor, {{{1, 1, 0}, {4, 1, 0}, {1, 2, 0}}}, {{1, 1, 0}, {4, 1, 0}}},
    {"overlap", kFloor, {{{-2, 3, 0}, {9, 3, 0}, {-2, 14, 0}}}, {{0, 3, 0}, {5, 3, 0}}},
    {"star of David",
     {{{0, 0, 0}, {12, 0, 0}, {6, 9, 0}}},
     {{{0, 6, 0}, {12, 6, 0}, {6, -3, 0}}},
     {{2, 3, 0}, {10, 3, 0}}},
    {"vertex on edge", kFloor, {{{4, 4, 0}, {9, 4, 0}, {4, 9, 0}}}, {{4, 4, 0}, {4, 4, 0}}},
    {"vertex on vertex", kFloor, {{{0, 0, 0}, {-8, 0, 0}, {0, -8, 0}}}, {{0, 0, 0}, {0, 0, 0}}},
    {"edges touch", kFloor, {{{2, 0, 0}, {3, 0, 0}, {2, -5, 0}}}, {{2, 0, 0}, {3, 0, 0}}},
};

constexpr Case kDegenerate[] = {
    {"point on itself", kDot, kDot, {{2, 2, 2}, {2, 2, 2}}},
    {"point on segment", kDot, kRod, {{2, 2, 2}, {2, 2, 2}}},
    {"point in face", kDot, {{{0, 0, 2}, {8, 0, 2}, {0, 8, 2}}}, {{2, 2, 2}, {2, 2, 2}}},
    {"the same segment", kRod, kRod, {{0, 0, 0}, {8, 8, 8}}},
    {"collinear segments", kRod, {{{7, 7, 7}, {9, 9, 9}, {12, 12, 12}}}, {{7, 7, 7}, {8, 8, 8}}},
    {"segments cross", kRod, {{{0, 8, 4}, {4, 4, 4}, {8, 0, 4}}}, {{4, 4, 4}, {4, 4, 4}}},
    {"segments touch in a T", kRod, {{{3, 3, 3}, {5, 2, 9}, {7, 1, 15}}}, {{3, 3, 3}, {3, 3, 3}}},
    {"segment pierces face", kFloor, {{{1, 1, -3}, {2, 2, 0}, {3, 3, 3}}}, {{2, 2, 0}, {2, 2, 0}}},
    {"segment in face", kFloor, {{{1, 1, 0}, {2, 2, 0}, {3, 3, 0}}}, {{1, 1, 0}, {3, 3, 0}}},
    {"segment across face", kFloor, {{{-1, 2, 0}, {9, 2, 0}, {3, 2, 0}}}, {{0, 2, 0}, {6, 2, 0}}},
    {"touches a vertex", kFloor, {{{7, -1, 0}, {8, 0, 0}, {9, 1, 0}}}, {{8, 0, 0}, {8, 0, 0}}},
};
constexpr Case kDegenerateBetweenCells[] = {
    {"segments cross between cells",
     {{{0, 0, 0}, {3, 3, 3}, {0, 0, 0}}},
     {{{0, 3, 0}, {0, 3, 0}, {3, 0, 3}}},
     {{384, 384, 384}, {384, 384, 384}}},
    {"segment pierces face between cells",
     kFloor,
     {{{1, 1, -1}, {2, 2, 2}, {2, 2, 2}}},
     {{341, 341, 0}, {341, 341, 0}}},
};

template <uint32_t kCount>
void check_cases(ContactKind kind, const Case (&cases)[kCount], int64_t cell = kFineOne) {
  for (const Case& c : cases) {
    INFO(c.name);
    REQUIRE(detail::triangles_intersect(c.a, c.b));
    const Contact contact = contact_of(c.a, c.b);
    CHECK(contact.kind == kind);
    for (int i = 0; i < 2; ++i) {
      CHECK(contact.ends[i].x == cell * c.ends[i].x);
      CHECK(contact.ends[i].y == cell * c.ends[i].y);
      CHECK(contact.ends[i].z == cell * c.ends[i].z);
    }
    CHECK(all_orders_give(contact, c.a, c.b));
  }
}

constexpr uint32_t kPairs = 20000 / share_on_board(32);

}  // namespace

TEST_CASE("contact: triangles that cross intersect in a segment or a point") {
  check_cases(ContactKind::segment, kCrossing);
  check_cases(ContactKind::segment, kCrossingBetweenCells, 1);
}
TEST_CASE("contact: of an area, two corners that are farthest apart") {
  check_cases(ContactKind::coplanar, kCoplanar);
}
TEST_CASE("contact: of segments and points, what they share") {
  check_cases(ContactKind::degenerate, kDegenerate);
  check_cases(ContactKind::degenerate, kDegenerateBetweenCells, 1);
}

TEST_CASE("contact: normals are exact cross products") {
  const Contact c = contact_of(kFloor, {{{0, 0, 0}, {0, 1, 0}, {0, 0, 2}}});
  CHECK(same(c.normal_a, {0, 0, 64}));
  CHECK(same(c.normal_b, {2, 0, 0}));
  const int32_t s = kMaxContactSpan;
  const Triangle large = {{{0, 0, 0}, {s, 0, s}, {0, s, s}}};
  const int64_t most = static_cast<int64_t>(s) * s;
  CHECK(same(contact_of(large, kRod).normal_a, {-most, -most, most}));
  CHECK(same(contact_of(large, kRod).normal_b, {0, 0, 0}));
  CHECK(same(contact_of(kDot, kRod).normal_a, {0, 0, 0}));
}

TEST_CASE("contact: the order of corners and of arguments moves no end") {
  uint32_t intersecting = 0;
  for_rounds(kPairs / 4, [&](Random& random, uint32_t) {
    const TransformedPair pair = any_pair(random);
    if (!detail::triangles_intersect(pair.a, pair.b)) {
      return;
    }
    ++intersecting;
    REQUIRE(all_orders_give(contact_of(pair.a, pair.b), pair.a, pair.b));
  });
  CHECK(intersecting > kPairs / 16);
}

TEST_CASE("contact: the order of arguments moves no point where long edges cross") {
  uint32_t intersecting = 0;
  for_rounds(4 * kPairs, [&](Random& random, uint32_t) {
    TransformedPair pair = {triangle_within(random, kMaxContactSpan),
                            triangle_within(random, kMaxContactSpan)};
    for (Triangle* t : {&pair.a, &pair.b}) {
      t->corner[2] = t->corner[1];
      for (Point& corner : t->corner) {
        corner.z = corner.x;
      }
    }
    if (!detail::triangles_intersect(pair.a, pair.b)) {
      return;
    }
    ++intersecting;
    REQUIRE(same_place(contact_of(pair.a, pair.b), contact_of(pair.b, pair.a)));
  });
  CHECK(intersecting > kPairs / 16);
}

TEST_CASE("contact: disjoint triangles do no harm, and their normals are right") {
  for_rounds(kPairs, [&](Random& random, uint32_t) {
    TransformedPair pair = any_pair(random);
    const TransformedPair other = any_pair(random);
    const TransformedPair far_a = translated_anywhere(random, {pair.a, pair.a});
    const TransformedPair far_b = translated_anywhere(random, {other.b, other.b});
    const Contact disjoint = contact_of(far_a.a, far_b.a);
    REQUIRE(same(disjoint.normal_a, contact_of(pair.a, pair.a).normal_a));
    REQUIRE(same(disjoint.normal_b, contact_of(other.b, other.b).normal_b));
  });
}

}  // namespace flashbvh::test
