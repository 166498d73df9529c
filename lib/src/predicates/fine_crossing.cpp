// The only division of a contact.
//
// Error, in steps of 1/256 cell: a fraction of at most 1/2 and both of its terms are cut to 31
// bits. So it is off by less than 2^-30 + 2^-31. An edge has at most 256 * 57,000 steps, which
// makes 0.021, and rounding adds a half.
#include "fine_crossing.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {
namespace {

constexpr unsigned kFractionBits = 31;

/// part / whole in 31 fraction bits; part <= whole / 2, whole < 2^63.
///
/// Restoring division, one bit per step: libgcc's 64-bit division has more code than this file, and
/// the Cortex-M0 has no other.
[[gnu::noinline]] int32_t fraction(uint64_t part, uint64_t whole) {
  unsigned surplus = 0;
  for (uint32_t high = static_cast<uint32_t>(whole >> kFractionBits); high != 0; high >>= 1) {
    ++surplus;
  }
  const uint32_t divisor = static_cast<uint32_t>(whole >> surplus);
  uint32_t rest = static_cast<uint32_t>(part >> surplus);
  uint32_t quotient = 0;
  for (unsigned i = 0; i < kFractionBits; ++i) {
    rest <<= 1;
    quotient <<= 1;
    if (rest >= divisor) {
      rest -= divisor;
      quotient |= 1;
    }
  }
  return static_cast<int32_t>(quotient);
}

inline uint64_t fine_magnitude(int64_t value) {
  return static_cast<uint64_t>(value < 0 ? -value : value);
}

/// Interpolates between two cells; the result is in 1/256 cell. `share`: in 31 fraction bits.
#if defined(__ARM_FEATURE_MVE)
[[gnu::noinline]]  // three inlined copies take 24 more bytes of stack there
#endif
int64_t
between(int32_t from, int32_t to, int32_t share) {
  const int64_t steps = static_cast<int64_t>((to - from) * kFineOne) * share;
  constexpr int64_t half = int64_t{1} << (kFractionBits - 1);
  return int64_t{from} * kFineOne + static_cast<int32_t>((steps + half) >> kFractionBits);
}

}  // namespace

[[gnu::noinline]] void set_crossing(const Point& p, const Point& q, int64_t height_p,
                                    int64_t height_q, FinePoint& point) {
  // Counts from the nearer end, so that the fraction is at most 1/2. At 1/2 both ends give an equal
  // point, because the middle of an edge is a whole number of steps.
  const uint64_t of_p = fine_magnitude(height_p);
  const uint64_t of_q = fine_magnitude(height_q);
  const bool p_is_nearer = of_p <= of_q;
  const Point& from = p_is_nearer ? p : q;
  const Point& to = p_is_nearer ? q : p;
  const int32_t share = fraction(p_is_nearer ? of_p : of_q, of_p + of_q);
  point = {between(from.x, to.x, share), between(from.y, to.y, share),
           between(from.z, to.z, share)};
}

}  // namespace flashbvh::detail
