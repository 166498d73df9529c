// Lengths in the steps of firmware's distances.
#pragma once

#include <cmath>
#include <cstdint>

#include "flashbvh/lattice.hpp"

namespace flashbvh::tool {

/// The least number of 1/256 cell that is not below `length`, apart from the 2^-50 of it that
/// doubles of decimals may be off: 0.9 is 3 cells of 0.3. UINT32_MAX, which firmware rejects, if
/// the length is negative, not a number or too large.
inline FineLength fine_length_rounded_up(double length, double cell) {
  constexpr double kOfDecimals = 0x1p-50;
  const double steps = std::ceil(length / cell * kFineOne * (1 - kOfDecimals));
  return {length >= 0 && steps < UINT32_MAX ? static_cast<std::uint32_t>(steps) : UINT32_MAX};
}

}  // namespace flashbvh::tool
