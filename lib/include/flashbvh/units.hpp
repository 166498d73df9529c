// Converts lengths from cells to the mesh's unit, in integers. float.hpp converts to floats.
#pragma once

#include <stdint.h>

namespace flashbvh {

/// Returns a length in millionths of the mesh's unit, rounded to the nearest: nanometres for
/// millimetres. `fine`: in 1/256 cell, within +-2^39. `cell_bits`: Mesh::cell_bits. Saturates at
/// INT64_MAX and -INT64_MAX.
///
/// Stack: 112 bytes on Cortex-M3 to M55 at -O2.
int64_t millionths_of(int64_t fine, uint64_t cell_bits);

namespace detail {

/// Returns the bits of the binary32 nearest to the length in the unit. Arguments as above.
uint32_t length_bits(int64_t fine, uint64_t cell_bits);

/// Returns the bits of the binary32 nearest to the number of cells in a unit. If this is a power of
/// two and not exact, returns the next one above.
uint32_t cells_per_unit_bits(uint64_t cell_bits);

/// digits * 2^exponent.
struct CellsPerUnit {
  uint64_t digits;  ///< from 2^38 to 2^39
  int32_t exponent;
};

/// Returns the number of cells in a unit, less an error of at most 2^-38 of it. A float has 2^-24:
/// 32 units of a joint's coordinate at 8 m, in cells of 0.02 mm.
CellsPerUnit exact_cells_per_unit(uint64_t cell_bits);

}  // namespace detail

}  // namespace flashbvh
