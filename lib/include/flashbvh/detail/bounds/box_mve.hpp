// The overlap test with Helium, the vector extension of Cortex-M55: a box is most of a vector, all
// six sums are one addition, and one branch follows.
//
// Bit-identical to the forms in packed.hpp: the fourth word's thresholds are zero.
//
// B's words are exchanged in registers. Gathering its halves in the order wanted takes four
// instructions fewer, but eight accesses to memory, which may cost more than they save
// (lib/docs/decisions/0008-helium.md). In assembly, since GCC extends the predicates' sign before
// it compares them, and makes the vector of thresholds again in each visit.
#ifndef FLASHBVH_DETAIL_BOUNDS_BOX_MVE_HPP
#define FLASHBVH_DETAIL_BOUNDS_BOX_MVE_HPP

#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"

// Clang has no name by which assembly could say that it changes the predicates.
#if defined(__ARM_FEATURE_MVE) && !defined(__clang__) && !defined(FLASHBVH_PORTABLE)
#define FLASHBVH_BOX_MVE 1

namespace flashbvh::detail {

using WordVector [[gnu::vector_size(16)]] = uint32_t;

/// The thresholds and a zero. Not volatile: a walk takes it out of its loop.
inline WordVector threshold_vector(const PackedTriple& least) {
  WordVector vector;
  __asm__(
      "vmov %q0[2], %q0[0], %1, %3\n\t"
      "vmov %q0[3], %q0[1], %2, %4"
      : "=&w"(vector)
      : "r"(least.word[0]), "r"(least.word[1]), "r"(least.word[2]), "r"(0));
  return vector;
}

/// Whether the six sums of bounds of `a` and `b` reach `least`. Reads the four bytes after each
/// box, too: the rest of its node.
inline bool bounds_reach_mve(const PackedBox& a, const PackedBox& b, const PackedTriple& least) {
  uint32_t missing;
  __asm__(
      "vldrw.u32 q1, [%2]\n\t"
      "vrev64.32 q2, q1\n\t"
      "vldrw.u32 q0, [%1]\n\t"
      "vmov.32 q2[2], %3\n\t"
      "vadd.i16 q0, q0, q2\n\t"
      "vcmp.u16 hi, %q4, q0\n\t"
      "vmrs %0, p0"
      : "=r"(missing)
      : "r"(&a), "r"(&b), "r"(swap_halves(b.z)), "w"(threshold_vector(least)), "m"(a), "m"(b)
      : "q0", "q1", "q2", "p0");
  return missing == 0;
}

}  // namespace flashbvh::detail

#endif

#endif
