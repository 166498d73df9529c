// A segment and a triangle against exact rationals: all kinds, in all sizes.
#include "predicates/segment_hit.hpp"
#include "support/oracles/rational.hpp"
#include "support/points.hpp"
#include "support/test.hpp"

namespace {

mpz_class number(std::int64_t value) {
  return static_cast<long>(value);
}

mpq_class rational(const SegmentShare& share) {
  mpq_class value(number(share.above), number(share.below));
  value.canonicalize();
  return value;
}

/// 1 if the triangle's corners run counter-clockwise, seen from the segment's start, -1 if
/// clockwise, 0 if the segment lies in the plane or there is none.
int side_met(const Segment& segment, const Triangle& t) {
  const auto at = [](const Point& p) { return vector_of<mpz_class>(p); };
  const Vector<mpz_class> o = at(t.corner[0]);
  const Vector<mpz_class> normal = cross(minus(at(t.corner[1]), o), minus(at(t.corner[2]), o));
  return -sgn(dot(normal, minus(at(segment.to), at(segment.from))));
}

/// The kinds of results so far, to check that all occur.
struct Seen {
  std::uint32_t hits = 0;
  std::uint32_t misses = 0;
  std::uint32_t in_plane = 0;
};

void check_segment(const Segment& segment, const Triangle& t, Seen& seen) {
  CAPTURE(segment.from.x, segment.from.y, segment.from.z, segment.to.x, segment.to.y, segment.to.z);
  CAPTURE(t.corner[0].x, t.corner[0].y, t.corner[0].z, t.corner[1].x, t.corner[1].y, t.corner[1].z,
          t.corner[2].x, t.corner[2].y, t.corner[2].z);
  const SegmentOracle truth(segment, t);
  SegmentShare along = {0, 1};
  std::int8_t side = 2;
  const bool hit = detail::first_meeting(segment, t, along, side);
  REQUIRE(hit == truth.meets());
  if (!hit) {
    ++seen.misses;
    return;
  }
  ++seen.hits;
  seen.in_plane += side == 0 ? 1 : 0;
  REQUIRE(along.below > 0);
  REQUIRE(rational(along) == truth.first());
  REQUIRE(side == side_met(segment, t));
  for (int i = 0; i < 6; ++i) {  // the last three orders reverse the triangle
    SegmentShare other = {0, 1};
    std::int8_t other_side = 2;
    REQUIRE(detail::first_meeting(segment, ordered(t, i), other, other_side));
    REQUIRE((order_along(along, other) == 0 && other_side == (i < 3 ? side : -side)));
  }
}

Point point_between(const Point& u, const Point& v, std::int32_t share) {
  return {u.x + share * (v.x - u.x), u.y + share * (v.y - u.y), u.z + share * (v.z - u.z)};
}

/// Whether the part of a segment from its start to `end`, a share of it, meets a box.
bool meets_box(const Segment& segment, const mpq_class& end, const Box& box) {
  mpq_class first = 0;
  mpq_class last = end;
  for (int i = 0; i < 3; ++i) {
    const std::int32_t from = segment.from.*kPointAxes[i];
    const std::int32_t way = segment.to.*kPointAxes[i] - from;
    const std::int32_t least = box.lower.*kVertexAxes[i];
    const std::int32_t most = box.upper.*kVertexAxes[i];
    if (way == 0) {
      if (from < least || from > most) {
        return false;
      }
      continue;
    }
    const mpq_class at_least = mpq_class(least - from) / way;
    const mpq_class at_most = mpq_class(most - from) / way;
    first = std::max(first, std::min(at_least, at_most));
    last = std::min(last, std::max(at_least, at_most));
  }
  return first <= last;
}

}  // namespace

TEST_CASE("a segment meets exactly the boxes that it has a point of, and no part of it is lost") {
  std::uint32_t met = 0;
  std::uint32_t missed = 0;
  std::uint32_t behind = 0;
  for_rounds(20'000, [&](Random& random, int round) {
    const std::int32_t reach = round % 2 == 0 ? 4 : 40;
    const Segment segment = {any_point(random, reach), any_point(random, reach)};
    const Point near = any_point(random, 4);  // offset from the segment's middle
    Box box{};
    for (int i = 0; i < 3; ++i) {
      const auto axis = kPointAxes[i];
      const std::int32_t at = (segment.from.*axis + segment.to.*axis) / 2 + near.*axis;
      box.lower.*kVertexAxes[i] = static_cast<std::int16_t>(at);
      box.upper.*kVertexAxes[i] = static_cast<std::int16_t>(at + random.between(0, 5));
    }
    detail::SegmentInBoxes boxes(segment);
    const bool meets = meets_box(segment, 1, box);
    REQUIRE(boxes.may_meet(pack(box)) == meets);
    ++(meets ? met : missed);
    // A shortened segment may meet boxes a few cells behind its end.
    const std::int64_t below = 1 + random.below(8);
    const std::int64_t above = random.below(static_cast<std::uint32_t>(below) + 1);
    boxes.shorten({above, below});
    const bool in_part = meets_box(segment, rational({above, below}), box);
    REQUIRE((boxes.may_meet(pack(box)) || !in_part));
    behind += meets && !boxes.may_meet(pack(box)) ? 1 : 0;
  });
  CAPTURE(met, missed, behind);
  CHECK((met > 2'000 && missed > 5'000 && behind > 500));
}

TEST_CASE("a segment first meets a triangle where exact rationals say") {
  Seen seen;
  // On few cells, everything coincides.
  const auto tries = rounds(8000u, 40'000u);
  for_rounds(tries, [&](Random& random, std::uint32_t) {
    const std::int32_t reach = 1 + static_cast<std::int32_t>(random.below(3));
    const Triangle t = any_triangle(random, reach);
    check_segment({any_point(random, reach), any_point(random, reach)}, t, seen);
  });
  CHECK((seen.hits > tries / 16 && seen.misses > tries / 8 && seen.in_plane > tries / 80));
}

TEST_CASE("a segment meets corners and edges of large triangles, from far off") {
  Seen seen;
  const auto tries = rounds(1000u, 6'000u);
  for_rounds(tries, [&](Random& random, std::uint32_t round) {
    const auto reach = static_cast<std::int32_t>(1 + random.below(kMaxCoordinate));
    const Triangle t = any_triangle(random, reach);
    const Point from = any_point(random, round % 2 == 0 ? reach : kMaxRayCoordinate / 2 - 40'000);
    // Through a corner, or the middle of an edge; twice as far, exactly there, or just short of it.
    const Point& u = random.one_of(t.corner);
    const Point& v = random.one_of(t.corner);
    const Point to = {u.x + v.x - from.x, u.y + v.y - from.y, u.z + v.z - from.z};
    check_segment({from, to}, t, seen);
    check_segment({to, from}, t, seen);
    check_segment({from, u}, t, seen);
    check_segment({u, point_between(u, v, 2)}, t, seen);
    check_segment({from, from}, t, seen);
    check_segment({from, {u.x, u.y, u.z + 1}}, t, seen);
    // In the plane, from next to an edge.
    check_segment({point_between(u, v, -1), t.corner[random.below(3)]}, t, seen);
    check_segment({point_between(u, v, -1), point_between(v, t.corner[0], 2)}, t, seen);
    // Triangles without area.
    check_segment({from, u}, {{u, v, u}}, seen);
    check_segment({from, to}, {{u, point_between(u, v, -1), v}}, seen);
    check_segment({point_between(u, v, -1), v}, {{u, v, v}}, seen);
    check_segment({from, u}, {{u, u, u}}, seen);
  });
  CHECK(
      (seen.hits > 10 * tries / 3 && seen.misses > 5 * tries / 6 && seen.in_plane > 5 * tries / 3));
}

TEST_CASE("at the ends of the range nothing overflows") {
  Seen seen;
  for_rounds(rounds(1500, 5'000), [&](Random& random, int) {
    const auto at_ends = [&](std::int32_t most) {
      const auto end = [&] { return random.below(2) == 0 ? most : -most; };
      return Point{end(), end(), end()};
    };
    const Triangle t = {
        {at_ends(kMaxCoordinate), at_ends(kMaxCoordinate), at_ends(kMaxCoordinate)}};
    const Point from = at_ends(kMaxRayCoordinate);
    check_segment({from, at_ends(kMaxRayCoordinate)}, t, seen);
    check_segment({from, {-from.x, -from.y, -from.z + 1}}, t, seen);
  });
  CHECK((seen.hits > 300 && seen.misses > 300));
}

TEST_CASE("shares of segments are distinguished by one part in 2^105") {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  CHECK(order_along({most - 2, most - 1}, {most - 1, most}) < 0);
  CHECK(order_along({most - 1, most}, {most - 2, most - 1}) > 0);
  CHECK(order_along({most / 2, most}, {1, 2}) == 0);
  CHECK(order_along({0, 5}, {0, most}) == 0);
}
