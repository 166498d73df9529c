// Lengths in the steps of firmware's distances.
#pragma once

#include <cstdint>

#include "flashbvh/lattice.hpp"

namespace flashbvh::tool {

/// The least number of 1/256 cell whose length, multiplied in doubles as outputs print it, is at
/// least `length`: 0.05 is 50 cells of 0.001. UINT32_MAX, which firmware rejects, if the length is
/// negative, not a number or too large.
inline FineLength fine_length_rounded_up(double length, double cell) {
  const double steps = length / cell * kFineOne;
  if (!(length >= 0 && steps < UINT32_MAX - 1)) {
    return {UINT32_MAX};
  }
  auto fine = static_cast<std::uint32_t>(steps);
  while (fine / double{kFineOne} * cell < length) {
    ++fine;
  }
  return {fine};
}

}  // namespace flashbvh::tool
