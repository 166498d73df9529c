// Lengths that queries report in cells, in a mesh's unit. In integers; lengths as floats are in
// float.hpp.
#ifndef FLASHBVH_UNITS_HPP
#define FLASHBVH_UNITS_HPP

#include <stdint.h>

namespace flashbvh {

/// `fine`, in 1/256 cell and within +-2^39, in millionths of the mesh's unit, to the nearest: of
/// millimetres, nanometres. `cell_bits`: Mesh::cell_bits. INT64_MAX or its negative for that much
/// or more.
///
/// Stack: 112 bytes on Cortex-M3 to M55 at -O2.
int64_t millionths_of(int64_t fine, uint64_t cell_bits);

namespace detail {

/// The bits of the binary32 nearest to the length in the unit.
uint32_t length_bits(int64_t fine, uint64_t cell_bits);

/// The bits of the binary32 nearest to the number of cells in a unit.
uint32_t cells_per_unit_bits(uint64_t cell_bits);

}  // namespace detail

}  // namespace flashbvh

#endif
