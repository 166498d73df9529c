// The overlap test for cores with the DSP extension (Cortex-M4, M7, M33, M55): the arithmetic of
// packed.hpp, and loads of two words at once (LDRD), which compilers do not find. Most disjoint
// boxes are apart along x or y, and the test then does not read z.
#pragma once

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

// Where nothing is optimised there are too few registers.
#if defined(__ARM_FEATURE_SIMD32) && defined(__thumb2__) && defined(__OPTIMIZE__) && \
    !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_BOX_DSP 1

namespace flashbvh::detail {

/// True if the six sums of bounds of `a` and `b` reach `least`.
FLASHBVH_INLINE inline bool bounds_reach_dsp(const PackedBox& a, const PackedBox& b,
                                             const PackedTriple& least) {
  __asm__ goto(
      "ldrd r2, r3, %0\n\t"
      "ldrd r0, r12, %1\n\t"
      "add r2, r2, r12\n\t"
      "uqsub16 r2, %2, r2\n\t"
      "add r3, r3, r0\n\t"
      "uqsub16 r3, %3, r3\n\t"
      "orrs r2, r2, r3\n\t"
      "bne %l[apart]"
      :
      : "Q"(a), "Q"(b), "r"(least.word[0]), "r"(least.word[1])
      : "r0", "r2", "r3", "r12", "cc"
      : apart);
  return __uqsub16(least.word[2], a.z + swap_halves(b.z)) == 0;
apart:
  return false;
}

}  // namespace flashbvh::detail

#endif
