// The rotated box test with Helium, the vector extension of Cortex-M55. A row of the matrix has a
// box's layout, so a bound of a rotated box is one dot product of eight halves (VMLADAVA).
//
// A rotated box stores lower bounds first, so that sums with another box need no exchange. Answers
// equal those of box_rotated.cpp, bit for bit. Whole cells from 32,768 to 65,535 are not clamped,
// but their sum with another bound, which is at least 1, saturates and reaches the bias.
//
// By LLVM's model of the core a rotated box takes a fifth fewer cycles than with SMLAD, and a
// quarter fewer instructions (lib/docs/decisions.md).
#ifndef FLASHBVH_BOUNDS_BOX_ROTATED_MVE_HPP
#define FLASHBVH_BOUNDS_BOX_ROTATED_MVE_HPP

#include "box_rotated_layout.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

// Adds q0, a rotated box, and q1, a box; `to` is not 0 if a sum is below the bias.
#define FLASHBVH_COMPARE(to) \
  "vqadd.u16 q1, q1, q0\n\t" \
  "vcmp.s16 ge, q1, zr\n\t"  \
  "vmrs " to                 \
  ", p0\n\t"                 \
  "lsls " to ", " to ", #20\n\t"

/// Rotates `box` and stores it in `rotated`; 0 if it overlaps `other`. 38 instructions.
///
/// r0 rotated, r1 box, r2 other. q0 is the box, q1 the box with upper and lower exchanged, q2 and
/// q3 rows; r5 rows, r3 starts; r4, r6, r8, r10, r12, lr the sums. Vectors of a box or a row also
/// load the word after it, which is not used.
extern "C" [[FLASHBVH_CALLED_BY_NAME]] uint32_t flashbvh_rotate_and_compare(
    RotatedBox& /*rotated*/, const PackedBox& /*box*/, const PackedBox& /*other*/) {
  __asm__(
      "push {r4, r5, r6, r8, r10, lr}\n\t"
      "ldm r1, {r4, r6, r12}\n\t"
      "mov r8, #0\n\t"
      "vmov q0[2], q0[0], r4, r12\n\t"
      "ldrd r5, r3, [r0, #16]\n\t"
      "vmov q0[3], q0[1], r6, r8\n\t"
      "vldrw.u32 q2, [r5]\n\t"
      "ror r12, r12, #16\n\t"
      "vmov q1[2], q1[0], r6, r12\n\t"
      "vmov q1[3], q1[1], r4, r8\n\t"
      "ldrd r4, r6, [r3]\n\t"
      "vldrw.u32 q3, [r5, #12]\n\t"
      "vmladava.s16 r4, q2, q0\n\t"
      "ldrd r8, r10, [r3, #8]\n\t"
      "vmladava.s16 r6, q2, q1\n\t"
      "vldrw.u32 q2, [r5, #24]\n\t"
      "vmladava.s16 r8, q3, q0\n\t"
      "ldrd r12, lr, [r3, #16]\n\t"
      "vmladava.s16 r10, q3, q1\n\t"
      "vmladava.s16 r12, q2, q0\n\t"
      "vmov q3[3], q3[1], r8, r8\n\t"
      "vmladava.s16 lr, q2, q1\n\t"
      "vmov q3[2], q3[0], r10, r12\n\t"
      "vmov q2[3], q2[1], r4, r4\n\t"
      "vmov q2[2], q2[0], r6, lr\n\t"
      // VQSHRUNB and VQSHRUNT.S32 of q2 and q3 to q0 by 14 bits: GNU as 2.40 takes the rounding
      // instructions for them.
      ".inst.w 0xEE920FC4\n\t"
      "vldrw.u32 q1, [r2]\n\t"
      ".inst.w 0xEE921FC6\n\t"
      "vstrw.32 q0, [r0]\n\t"
      "str r1, [r0, #12]\n\t" FLASHBVH_COMPARE("r0") "pop {r4, r5, r6, r8, r10, pc}");
}

/// 12 instructions where a current box separates the two, 50 or more where one is rotated.
[[gnu::naked]] uint32_t RotatedBoxTest::gap(const PackedBox& /*a*/, const PackedBox& /*b*/) {
#define FLASHBVH_EXCHANGE_BOXES \
  "mov r3, r1\n\t"              \
  "mov r1, r2\n\t"              \
  "mov r2, r3\n\t"
  __asm__(
      "ldr r3, [r0, #36]\n\t"
      "cmp r3, r2\n\t"
      "beq 1f\n\t"
      "ldr r3, [r0, #12]\n\t"
      "cmp r3, r1\n\t"
      "bne 2f\n\t"
      // A's box is current, seen from B.
      "vldrw.u32 q0, [r0]\n\t"
      "vldrw.u32 q1, [r2]\n\t"
      "add r0, r0, #24\n\t"
      FLASHBVH_EXCHANGE_BOXES
      "b 3f\n\t"
      // None is.
      "2:\n\t"
      "push {r0, r1, r2, lr}\n\t"
      "add r0, r0, #24\n\t"
      FLASHBVH_EXCHANGE_BOXES
      "bl flashbvh_rotate_and_compare\n\t"
      "movs r3, r0\n\t"
      "pop {r0, r1, r2, lr}\n\t"
      "b 4f\n\t"
      // B's is.
      "1:\n\t"
      "vldrw.u32 q0, [r0, #24]\n\t"
      "vldrw.u32 q1, [r1]\n\t"
      "3:\n\t"
      FLASHBVH_COMPARE("r3")
      "4:\n\t"
      "beq.w flashbvh_rotate_and_compare\n\t"
      "mov r0, r3\n\t"
      "bx lr");
#undef FLASHBVH_EXCHANGE_BOXES
}

#undef FLASHBVH_COMPARE

}  // namespace flashbvh::detail

#endif
