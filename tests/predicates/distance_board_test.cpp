// Separation tests of triangles in 32 bits against 64 bits, at a query's largest distance;
// quotients of 128-bit numbers, multiplied back by hand: equal on every core.
#include <stdint.h>

#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "predicates/long_division.hpp"
#include "support/points.hpp"
#include "support/rounds.hpp"

namespace flashbvh::test {
namespace {

/// Slightly more than twice the largest distance of a mesh's corners along an axis.
constexpr int32_t kFarthest = 70000;

int64_t dot(const int64_t (&direction)[3], const Point& p) {
  return direction[0] * p.x + direction[1] * p.y + direction[2] * p.z;
}

/// The definition: the direction between the middles, of 12 bits per component.
bool middles_separate_in_64_bits(const Triangle& a, const Triangle& b) {
  int64_t d[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    d[0] += b.corner[i].x - a.corner[i].x;
    d[1] += b.corner[i].y - a.corner[i].y;
    d[2] += b.corner[i].z - a.corner[i].z;
  }
  const auto size = [](int64_t value) { return value < 0 ? -value : value; };
  while (((size(d[0]) | size(d[1]) | size(d[2])) >> 12) != 0) {
    for (int64_t& component : d) {
      component >>= 1;
    }
  }
  int64_t most = INT64_MIN;
  int64_t least = INT64_MAX;
  for (int i = 0; i < 3; ++i) {
    most = dot(d, a.corner[i]) > most ? dot(d, a.corner[i]) : most;
    least = dot(d, b.corner[i]) < least ? dot(d, b.corner[i]) : least;
  }
  return most < least;
}

using detail::Int128;

constexpr int kHalves = 16;  // of 16-bit words: 256 bits

/// A number in columns of 16 bits.
struct Columns {
  uint32_t word[kHalves] = {};

  explicit Columns(const Int128& u) {
    for (int i = 0; i < 8; ++i) {
      const uint64_t half = i < 4 ? u.low : static_cast<uint64_t>(u.high);
      word[i] = static_cast<uint32_t>(half >> (16 * (i % 4)) & 0xFFFF);
    }
  }
  Columns() = default;
};

/// u v + w.
Columns multiplied(const Columns& u, const Columns& v, const Columns& w) {
  Columns sum = w;
  for (int i = 0; i < 8; ++i) {
    uint32_t carry = 0;
    for (int j = 0; i + j < kHalves; ++j) {
      const uint32_t at = sum.word[i + j] + u.word[i] * v.word[j] + carry;
      sum.word[i + j] = at & 0xFFFF;
      carry = at >> 16;
    }
  }
  return sum;
}

bool is_below(const Columns& u, const Columns& v) {
  for (int i = kHalves - 1; i >= 0; --i) {
    if (u.word[i] != v.word[i]) {
      return u.word[i] < v.word[i];
    }
  }
  return false;
}

/// Whether whole v <= u < whole v + v.
bool is_quotient(const Int128& whole, const Int128& u, const Int128& v) {
  const Columns product = multiplied(Columns(whole), Columns(v), Columns());
  const Columns next = multiplied(Columns(whole), Columns(v), Columns(v));
  return !is_below(Columns(u), product) && is_below(Columns(u), next);
}

/// A number of at most `bits` bits, with its leading or trailing bits all set, or random.
Int128 any_number(Random& random, uint32_t bits) {
  const uint32_t kind = random.below(4);
  const uint64_t set = kind == 0 ? UINT64_MAX : 0;
  uint64_t high = kind <= 1 ? set : random.next();
  uint64_t low = kind == 1 ? 1 : kind == 2 ? 0 : random.next() | set;
  const uint32_t down = 128 - bits;  // 1 or more
  low = down >= 64 ? high >> (down - 64) : low >> down | high << (63 - down) << 1;
  high = down >= 64 ? 0 : high >> down;
  return {static_cast<int64_t>(high), low};
}

}  // namespace

TEST_CASE("separated triangles are detected in 32 bits as in 64, on every core") {
  Random random(5);
  uint32_t sum = 2166136261u;
  uint32_t separated = 0;
  for (int round = 0; round < 4000; ++round) {
    const int32_t size = 1 << random.below(15);
    const int32_t far = round % 4 != 0 ? 2 * size : kFarthest;
    const Triangle a = any_triangle(random, size);
    const Point at = any_point(random, far);
    const Triangle b = shifted(any_triangle(random, size), at);
    const bool by_middles = detail::middles_separate(a, b);
    CAPTURE(round);
    REQUIRE(by_middles == middles_separate_in_64_bits(a, b));
    detail::Direction first;
    const bool by_directions = detail::directions_separate(a, b, 0, first);
    separated += by_middles ? 1 : 0;
    sum = (sum ^ (by_directions ? 1u : 0u) ^ first.packed) * 16777619u;
  }
  CHECK(separated > 1000);
  CHECK(sum == 0x132BB45Au);
}

TEST_CASE("quotients of 128 bits, multiplied back, are what was divided") {
  constexpr Int128 most = {INT64_MAX, UINT64_MAX};
  constexpr Int128 one = {0, 1};
  for_rounds(4000, [&](Random& random, int round) {
    Int128 u = round % 50 == 0 ? most : any_number(random, 64 + random.below(64));
    Int128 v = round % 70 == 0 ? most : any_number(random, 64 + random.below(64));
    if (round % 3 == 0) {
      v = any_number(random, 64);
    }
    v = round % 90 == 0 || detail::is_zero(v) ? one : v;
    u = round % 11 == 0 ? v : round % 13 == 0 ? v - one : u;  // quotients of 1, and just below
    CAPTURE(u.high, u.low, v.high, v.low);
    const Int128 whole = detail::quotient(u, v);
    REQUIRE(is_quotient(whole, u, v));
    REQUIRE(detail::long_quotient(u, v) == whole);
  });
  REQUIRE(detail::is_zero(detail::long_quotient({0, 0}, most)));
}

TEST_CASE("roots of 128 bits are the largest whose squares are not above") {
  for_rounds(4000, [&](Random& random, int round) {
    Int128 u = any_number(random, 1 + random.below(127));
    // A square, and its neighbours.
    const uint64_t own = detail::square_root(u);
    const Int128 square = own <= INT64_MAX ? detail::full_product(static_cast<int64_t>(own),
                                                                  static_cast<int64_t>(own))
                                           : u;
    u = round % 3 == 0 ? square : round % 3 == 1 && own != 0 ? square - Int128{0, 1} : u;
    u = round == 0 ? Int128{INT64_MAX, UINT64_MAX} : round == 1 ? Int128{0, 0} : u;
    CAPTURE(u.high, u.low);
    const uint64_t root = detail::square_root(u);
    REQUIRE(detail::long_root(u) == root);
    // root^2 <= u < (root + 1)^2, by quotients of u.
    const Int128 whole = detail::quotient(u, {0, root == 0 ? 1 : root});
    REQUIRE((root == 0 || whole.high > 0 || whole.low >= root));
    const Int128 next = detail::quotient(u, {0, root + 1});
    REQUIRE((next.high == 0 && next.low < root + 1));
  });
}

}  // namespace flashbvh::test
