// Distances of triangles against exact rationals.
#include <set>

#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "predicates/long_division.hpp"
#include "support/oracles/rational.hpp"
#include "support/points.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

mpz_class number_of(const Int128& value) {
  mpz_class high(static_cast<long>(value.high));
  mpz_class low(static_cast<unsigned long>(value.low));
  return (high << 64) + low;
}
mpq_class rational(const Int128& above, const Int128& below) {
  mpq_class value(number_of(above), number_of(below));
  value.canonicalize();
  return value;
}
mpq_class rational_of(const Fraction& fraction) {
  return rational(fraction.above, fraction.below);
}

mpq_class squared_distance(const Triangle& a, const Triangle& b, Features& features) {
  Fraction squared = kInfinite;
  REQUIRE(is_nearer(a, b, squared, features));
  return rational_of(squared);
}

RationalVector point_at(const Triangle& t, const PlaceInTriangle& place) {
  const Point& p = t.corner[place.origin];
  const Point& q = t.corner[(place.origin + 1) % 3];
  const Point& r = t.corner[(place.origin + 2) % 3];
  const mpq_class s = rational(place.first, place.below);
  const mpq_class u = rational(place.second, place.below);
  CHECK((s >= 0 && u >= 0 && s + u <= 1));
  const auto at = [](const Point& corner) { return vector_of<mpq_class>(corner); };
  return plus(plus(at(p), s, minus(at(q), at(p))), u, minus(at(r), at(p)));
}

/// A squared distance, accurate to one part in 2^40.
Fraction fraction_of(const mpq_class& value) {
  const auto wide = [](const mpz_class& number) -> Int128 {
    const mpz_class high = number >> 64;
    const mpz_class low = number - (high << 64);
    return {static_cast<std::int64_t>(high.get_si()), low.get_ui()};
  };
  return {wide(value.get_num()), wide(value.get_den())};
}

/// What pairs of triangles were so far, to check that each kind occurs.
struct Seen {
  std::set<FeatureKind> kinds;
  std::uint32_t directions = 0;
  std::uint32_t planes = 0;
  std::uint32_t pairs = 0;
  std::uint32_t others = 0;  ///< separated by another pair's planes
  long close = 0;            ///< cases less than 1/1,000 cell nearer
  Direction first;           ///< another pair's, like a query's
  SupportPlanes planes_before;
  mpq_class distance_before = 0;  ///< squared, of the planes' own pair
};

/// Checks that the separation tests never separate nearer triangles.
void check_separations(const Triangle& a, const Triangle& b, const Features& features,
                       const mpq_class& truth, Seen& seen) {
  const mpz_class whole = truth.get_num() / truth.get_den();
  const std::int64_t limit = whole.get_si();  // the truth is less than 1 above it
  REQUIRE_FALSE(directions_separate(a, b, limit, seen.first));
  REQUIRE_FALSE(planes_separate(a, b, limit));
  const std::int64_t less = limit - limit / 64 - 1;
  seen.directions += limit > 64 && directions_separate(a, b, less, seen.first) ? 1 : 0;
  seen.planes += limit > 64 && planes_separate(a, b, less) ? 1 : 0;
  if (seen.planes_before.separates(a, b)) {
    ++seen.others;
    REQUIRE(truth >= seen.distance_before);
  }
  if (truth != 0) {
    ++seen.pairs;
    seen.planes_before = SupportPlanes(a, b, features);
    seen.distance_before = truth;
  }
}

/// Moves B `moves` times by whole cells, nearly normal to the direction: the planes must separate
/// exactly if B gets no nearer. Returns how often B gets nearer by so little that high parts are
/// equal.
long check_planes(Random& random, const Triangle& a, const Triangle& b, const Features& features,
                  const RationalVector& apart, bool is_far, int moves) {
  SupportPlanes own(a, b, features);
  if (is_far) {
    own.widen();
  }
  const FloatVector n = {apart[0].get_d(), apart[1].get_d(), apart[2].get_d()};
  const double length = length_of(n);
  long close = 0;
  for (int i = 0; i < moves; ++i) {
    const Point to = any_point(random, 400);
    const FloatVector way = vector_of<double>(to);
    const FloatVector across = plus(way, -test::dot(way, n) / (length * length), n);
    const auto rounded = [&](std::size_t axis) {
      return static_cast<std::int32_t>(std::lround(across[axis]));
    };
    const Point step = {rounded(0), rounded(1), rounded(2)};
    const mpq_class nearer = -test::dot(apart, vector_of<mpq_class>(step));
    CAPTURE(step.x, step.y, step.z);
    REQUIRE(own.separates(a, shifted(b, step)) == (nearer <= 0));
    close += nearer > 0 && nearer.get_d() < 1e-3 * length ? 1 : 0;
  }
  return close;
}

/// Tests the exact distance and its neighbours, or the nearest that a query can have.
void check_within(const Triangle& a, const Triangle& b, const mpq_class& truth) {
  const mpz_class most_above = (mpz_class(1) << 46) - 1;
  const mpz_class most_below = (mpz_class(1) << 17) - 1;
  mpz_class below = truth.get_den();
  if (below > most_below) {
    below = most_below;
  }
  // The denominator is the largest multiple, so that its steps are small.
  below *= most_below / below;
  mpz_class above = truth.get_num() * below / truth.get_den();  // rounded down
  for (int beside = -1; beside <= 1; ++beside) {
    const mpz_class at = above + beside;
    if (at >= 0 && at <= most_above) {
      const ShortFraction limit = {at.get_ui(), static_cast<std::uint32_t>(below.get_ui())};
      REQUIRE(is_within(a, b, limit) == (mpq_class(at, below) >= truth));
    }
  }
}

/// Checks the distance of the nearest points; returns the vector from A's to B's.
RationalVector check_places(const Triangle& a, const Triangle& b, const Features& features,
                            const mpq_class& truth) {
  PlaceInTriangle of_a{};
  PlaceInTriangle of_b{};
  nearest_places(a, b, features, of_a, of_b);
  const RationalVector apart = minus(point_at(b, of_b), point_at(a, of_a));
  REQUIRE(test::dot(apart, apart) == truth);
  return apart;
}

/// `is_far`: beyond the range of the tests that need kMaxApart.
void check(Random& random, const Triangle& a, const Triangle& b, Seen& seen, bool is_far = false,
           int moves = 32) {
  const mpq_class truth = Differences(a, b).squared_distance();
  Features features{};
  Features other{};
  REQUIRE(squared_distance(a, b, features) == truth);
  REQUIRE(squared_distance(b, a, other) == truth);
  REQUIRE((truth == 0) == (features.kind == FeatureKind::intersection));
  seen.kinds.insert(features.kind);
  if (!is_far) {
    REQUIRE(mpq_class(squared_box_gap(a, b)) <= truth);
    REQUIRE((squared_box_gap(a, b) != 0 || triangles_intersect(a, b) == (truth == 0)));
    check_separations(a, b, features, truth, seen);
    check_within(a, b, truth);
  }
  if (truth == 0) {
    REQUIRE(is_within(a, b, {0, 1}));
    return;
  }
  const RationalVector apart = check_places(a, b, features, truth);
  REQUIRE(rational_of(squared_between(a, b, features)) == truth);
  seen.close += check_planes(random, a, b, features, apart, is_far, moves);
  const Fraction exact = fraction_of(truth);
  Fraction same = exact;
  REQUIRE_FALSE(is_nearer(a, b, same, other));
  Fraction more = fraction_of(mpq_class(truth.get_num() + 1, truth.get_den()));
  REQUIRE((is_far || is_nearer(a, b, more, other)));
  const mpz_class below = (truth.get_num() - 1) / truth.get_den();
  REQUIRE(mpz_class(static_cast<long>(largest_below(exact, 0))) == below);
  const mpz_class steps = sqrt(mpz_class(truth.get_num() * 65536 / truth.get_den()));
  for (int beside = -1; beside <= 1 && steps > 0; ++beside) {
    const mpz_class limit = (steps + beside) * (steps + beside);
    REQUIRE(is_within(a, b, {limit.get_ui(), 65536}) == (mpq_class(limit, 65536) >= truth));
  }
}

/// Makes a pair degenerate: flat in some way, or with shared parts.
void adapt(Random& random, unsigned kind, Triangle& a, Triangle& b) {
  switch (kind) {
    case 1:  // segments
      b.corner[2] = b.corner[1];
      break;
    case 2:
      a.corner[1] = a.corner[0];
      b.corner[2] = b.corner[0];
      break;
    case 3:  // points
      a.corner[2] = a.corner[1] = a.corner[0];
      break;
    case 4:  // one plane
      for (int i = 0; i < 3; ++i) {
        a.corner[i].z = a.corner[i].x + a.corner[i].y;
        b.corner[i].z = b.corner[i].x + b.corner[i].y;
      }
      break;
    case 5:  // parallel planes
      for (int i = 0; i < 3; ++i) {
        a.corner[i].z = a.corner[i].x;
        b.corner[i].z = b.corner[i].x + 3;
      }
      break;
    case 6:  // a common corner
      b.corner[random.below(3)] = random.one_of(a.corner);
      break;
    case 7:  // parallel edges
      b.corner[1] = sum(b.corner[0], sum(a.corner[1], scaled(-1, a.corner[0])));
      break;
    case 8:  // on one line
      a.corner[2] = sum(scaled(2, a.corner[1]), scaled(-1, a.corner[0]));
      break;
    default:
      break;
  }
}

}  // namespace

TEST_CASE("distances of triangles are those of exact rationals") {
  Seen seen;
  const std::int32_t reaches[] = {1, 3, 30, 1000, 4000, 16000, 30000};
  const std::int32_t offsets[] = {0, 2, 50, 1500, 8000, 30000, 60000};
  const auto tries = rounds(800u, 4000u);
  for_rounds(tries, [&](Random& random, std::uint32_t) {
    const std::int32_t reach = random.one_of(reaches);
    const std::int32_t offset = random.one_of(offsets);
    Triangle a = any_triangle(random, reach);
    Triangle b = any_triangle(random, reach);
    adapt(random, random.below(12), a, b);
    b = shifted(b, any_point(random, offset));
    check(random, a, b, seen);
  });
  CHECK(seen.kinds.size() == 7);
  CHECK(seen.directions > tries / 8);
  CHECK(seen.planes > tries / 25);
  CHECK(seen.pairs > tries / 8);
  CHECK(seen.others > tries / 160);
  CHECK(seen.close > tries / 200);
}

TEST_CASE("pairs of triangles of two unit cubes, which share an edge, a corner or nothing") {
  Random random = test_random();
  // A corner, and each set of it and one or two others: ties, flat and touching triangles.
  std::vector<Triangle> all = {{}};
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < i; ++j) {
      const Point p = {j & 1, j >> 1 & 1, j >> 2};
      const Point q = {i & 1, i >> 1 & 1, i >> 2};
      all.push_back({{{0, 0, 0}, p, q}});
    }
  }
  Seen seen;
  for (const Triangle& a : all) {
    for (const Triangle& b : all) {
      for (std::int32_t z = 0; z < 3; ++z) {
        check(random, a, shifted(b, {1, 1, z}), seen, false, 1);
      }
    }
  }
  CHECK(seen.kinds.size() >= 4);
  CHECK(seen.pairs > all.size() * all.size());  // all with z = 2 are apart, and others
}

TEST_CASE("distances at the ends of their range") {
  Random random = test_random();
  Seen seen;
  constexpr std::int32_t m = 28377;
  constexpr std::int32_t far = 48000 + m;
  const Triangle a = {{{-16383, -16383, -16383}, {16383, -16383, -16383}, {-16383, 16383, -16383}}};
  for (int signs = 0; signs < 8; ++signs) {
    const std::int32_t x = (signs & 1) != 0 ? far : -far;
    const std::int32_t y = (signs & 2) != 0 ? far : -far;
    const std::int32_t z = (signs & 4) != 0 ? far : -far;
    check(random, a, {{{x, y, z}, {x - 2 * m, y, z}, {x, y - 2 * m, z}}}, seen);
    check(random, a, {{{x, y, z}, {x, y, z}, {-x, -y, -z}}}, seen);
    check(random, a, {{{x, y, z}, {x, y, -z}, {-x, y, z}}}, seen);
  }
  CHECK(seen.kinds.size() >= 3);
}

TEST_CASE("distances of meshes' triangles are exact up to kMaxFarApart") {
  Seen seen;
  for_rounds(rounds(300u, 3000u), [&](Random& random, std::uint32_t round) {
    const std::int32_t reaches[] = {2, 40, 1000, 9000, 16383};
    constexpr std::int32_t most = 1 << 20;
    Triangle a = any_triangle(random, random.one_of(reaches));
    Triangle b = any_triangle(random, random.one_of(reaches));
    if (round % 8 == 0) {
      constexpr std::int32_t m = 16383;
      constexpr std::int32_t n = 28377;
      a = {{{-m, -m, -m}, {m, -m, m}, {-m, m, m}}};
      b = {{{0, 0, n}, {0, n, 0}, {n, 0, 0}}};
    }
    adapt(random, random.below(12), a, b);
    Point by = any_point(random, most);
    (round % 3 == 0 ? by.x : round % 3 == 1 ? by.y : by.z) = round % 2 == 0 ? most : -most;
    if (round % 5 == 0) {  // corner to corner
      by = {round % 2 == 0 ? most : -most, most, -most};
    } else if (round % 5 == 1) {  // one above the other, parallel
      for (int i = 0; i < 3; ++i) {
        a.corner[i].z = 0;
        b.corner[i].z = i == 0 && round % 2 == 0 ? -1 : 0;
      }
      by = {by.x >> 16, by.y >> 16, most};
    }
    check(random, a, shifted(b, by), seen, true);
  });
  CHECK(seen.kinds.size() > 3);
  CHECK(seen.close > 0);
}

TEST_CASE("fractions are compared exactly, however near they are") {
  Random random = test_random();
  const auto any = [&random](unsigned bits) {
    mpz_class value = 1;
    for (unsigned i = 0; i < bits; ++i) {
      value = value * 2 + static_cast<unsigned long>(random.below(2));
    }
    return value;
  };
  const auto any_quotient = [&] {
    const mpz_class above = any(random.below(107));
    return mpq_class(above, any(random.below(71)));
  };
  for (unsigned round = 0; round < 20000; ++round) {
    CAPTURE(round);
    const mpq_class x = any_quotient();
    mpq_class y = any_quotient();
    if (round % 2 == 0) {  // a neighbouring quotient
      y = mpq_class(x.get_num() + (round % 3 == 0 ? 1 : 0), x.get_den() + (round % 5 == 0 ? 1 : 0));
    }
    const int order = cmp(x, y);
    const Fraction of_x = {fraction_of(mpq_class(x.get_num())).above,
                           fraction_of(mpq_class(x.get_den())).above};
    const Fraction of_y = {fraction_of(mpq_class(y.get_num())).above,
                           fraction_of(mpq_class(y.get_den())).above};
    REQUIRE(compare(of_x, of_y) == (order > 0 ? 1 : order < 0 ? -1 : 0));
    const Int128 whole = quotient(of_x.above, of_x.below);
    REQUIRE(number_of(whole) == x.get_num() / x.get_den());
    mpz_class root;
    mpz_sqrt(root.get_mpz_t(), x.get_num().get_mpz_t());
    REQUIRE(mpz_class(static_cast<unsigned long>(square_root(of_x.above))) == root);
    REQUIRE(long_quotient(of_x.above, of_x.below) == whole);
    REQUIRE(long_root(of_x.above) == square_root(of_x.above));
  }
}

TEST_CASE("quotients and roots of machines without 128-bit divisions are exact at their ends") {
  const Int128 numbers[] = {{INT64_MAX, UINT64_MAX}, {INT64_MAX, 0}, {1, 0}, {0, UINT64_MAX},
                            {0, UINT64_MAX - 1},     {0, 2},         {0, 1}, {0, 0}};
  for (const Int128& u : numbers) {
    CAPTURE(u.high, u.low);
    CHECK(long_root(u) == square_root(u));
    CHECK(mpz_class(static_cast<unsigned long>(square_root(u))) == sqrt(number_of(u)));
    for (const Int128& v : numbers) {
      if (!is_zero(v)) {
        CHECK(number_of(long_quotient(u, v)) == number_of(u) / number_of(v));
        CHECK(long_quotient(u, v) == quotient(u, v));
      }
    }
  }
}
