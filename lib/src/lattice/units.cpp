// Multiplies a number of cells by the cell's length, exactly in 128 bits, and rounds once.
#include "flashbvh/units.hpp"

namespace flashbvh {
namespace {

/// (high * 2^64 + low) * 2^exponent.
struct Wide {
  uint64_t high;
  uint64_t low;
  int32_t exponent;
};

/// digits * 2^exponent; 53 bits, the first of them 1.
struct Cell {
  uint64_t digits;
  int32_t exponent;
};

constexpr unsigned kFineBits = 8;
constexpr uint32_t kInfinity = 0x7F800000u;

Cell cell_of(uint64_t bits) {
  constexpr uint64_t one = uint64_t{1} << 52;
  return {one | (bits & (one - 1)), static_cast<int32_t>(bits >> 52 & 0x7FF) - 1075};
}

/// `factor` below 2^32.
void multiply(Wide& wide, uint32_t factor) {
  const uint64_t low = (wide.low & UINT32_MAX) * factor;
  const uint64_t middle = (wide.low >> 32) * factor + (low >> 32);
  wide.high = wide.high * factor + (middle >> 32);
  wide.low = (middle << 32) | (low & UINT32_MAX);
}

/// |fine| / 256 cells of this length. `fine`: within +-2^39; the two words are at most 2^92.
Wide wide_product(int64_t fine, uint64_t cell_bits) {
  const uint64_t size = static_cast<uint64_t>(fine < 0 ? -fine : fine);
  const Cell cell = cell_of(cell_bits);
  Wide wide = {0, cell.digits, cell.exponent - static_cast<int32_t>(kFineBits)};
  multiply(wide, static_cast<uint32_t>(size));
  wide.high += (cell.digits * (size >> 32)) >> 32;
  const uint64_t carried = (cell.digits * (size >> 32)) << 32;
  wide.low += carried;
  wide.high += wide.low < carried ? 1 : 0;
  return wide;
}

/// Shifts the two words down by `bits`; rounds to the nearest, ties to even. The result must fit 64
/// bits.
uint64_t shifted_down(const Wide& wide, int32_t bits) {
  if (bits <= 0 || bits > 127) {
    return bits <= 0 ? wide.low : 0;
  }
  const bool by_word = bits > 64;
  const uint64_t high = by_word ? 0 : wide.high;
  const uint64_t low = by_word ? wide.high : wide.low;
  const int32_t down = by_word ? bits - 64 : bits;  // 1 to 64
  const int32_t up = 64 - down;
  const uint64_t kept = up == 0 ? high : high << up | low >> down;
  const uint64_t cut = low << up;  // the dropped bits; the top one is a half
  const bool more = (cut << 1) != 0 || (by_word && wide.low != 0) || (kept & 1) != 0;
  return kept + ((cut >> 63) != 0 && more ? 1 : 0);
}

int32_t leading_bit(const Wide& wide) {
  const uint64_t word = wide.high != 0 ? wide.high : wide.low;
  int32_t bit = wide.high != 0 ? 64 : 0;
  for (uint64_t rest = word >> 1; rest != 0; rest >>= 1) {
    ++bit;
  }
  return bit;
}

/// The bits of the nearest binary32; infinity on overflow.
uint32_t float_bits(const Wide& wide) {
  if ((wide.high | wide.low) == 0) {
    return 0;
  }
  const int32_t leading = leading_bit(wide) + wide.exponent;
  const int32_t least = leading < -126 ? -149 : leading - 23;  // the last digit's exponent
  const int32_t down = least - wide.exponent;
  const uint64_t digits = down >= 0 ? shifted_down(wide, down) : wide.low << -down;
  // A carry out of the digits raises the exponent.
  const int64_t bits = static_cast<int64_t>(digits) + ((int64_t{least} + 149) << 23);
  return bits < kInfinity ? static_cast<uint32_t>(bits) : kInfinity;
}

struct Quotient {
  uint64_t digits;
  bool is_exact;
};

/// 2^(52 + bits) / divisor, rounded down, by restoring division; `divisor` has 53 bits.
Quotient inverse(uint64_t divisor, int bits) {
  uint64_t rest = uint64_t{1} << 52;
  uint64_t quotient = 0;
  for (int i = 0; i <= bits; ++i) {
    const bool fits = rest >= divisor;
    rest -= fits ? divisor : 0;
    quotient = quotient << 1 | (fits ? 1 : 0);
    rest <<= 1;  // below 2^54
  }
  return {quotient, rest == 0};
}

}  // namespace

int64_t millionths_of(int64_t fine, uint64_t cell_bits) {
  Wide wide = wide_product(fine, cell_bits);
  multiply(wide, 1'000'000);
  int64_t size = INT64_MAX;
  if ((wide.high | wide.low) == 0) {
    size = 0;
  } else if (leading_bit(wide) + wide.exponent < 63) {
    const uint64_t rounded =
        wide.exponent <= 0 ? shifted_down(wide, -wide.exponent) : wide.low << wide.exponent;
    size = rounded < INT64_MAX ? static_cast<int64_t>(rounded) : INT64_MAX;
  }
  return fine < 0 ? -size : size;
}

namespace detail {

uint32_t length_bits(int64_t fine, uint64_t cell_bits) {
  return float_bits(wide_product(fine, cell_bits)) | (fine < 0 ? 0x80000000u : 0u);
}

/// 2^84 / digits has 32 or 33 bits; the remainder excludes a tie.
uint32_t cells_per_unit_bits(uint64_t cell_bits) {
  constexpr int kQuotientBits = 32;
  const Cell cell = cell_of(cell_bits);
  const Quotient found = inverse(cell.digits, kQuotientBits);
  const Wide wide = {0, found.digits << 1 | (found.is_exact ? 0u : 1u),
                     -52 - kQuotientBits - 1 - cell.exponent};
  const uint32_t bits = float_bits(wide);
  const bool is_power = bits - 1 < kInfinity - 1 && (bits & 0x7FFFFF) == 0;
  return bits + (is_power && cell.digits != uint64_t{1} << 52 ? 1 : 0);
}

CellsPerUnit exact_cells_per_unit(uint64_t cell_bits) {
  constexpr int kQuotientBits = 39;
  const Cell cell = cell_of(cell_bits);
  return {inverse(cell.digits, kQuotientBits).digits, -52 - kQuotientBits - cell.exponent};
}

}  // namespace detail

}  // namespace flashbvh
