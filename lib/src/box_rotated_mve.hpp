// The inner steps of the rotated box test with Helium, the vector extension of Cortex-M55: a row of
// the matrix lies as the box does, so one dot product of eight halves (VMLADAVA) is a bound.
//
// Bit-identical to box_rotated.cpp where it decides: whole cells above 32,767 are kept up to
// 65,535, and the sum with a bound saturates, so that it reaches the bias all the same.
#ifndef FLASHBVH_BOX_ROTATED_MVE_HPP
#define FLASHBVH_BOX_ROTATED_MVE_HPP

#include <stddef.h>

#include "flashbvh/box_rotated.hpp"

namespace flashbvh {

static_assert(offsetof(TurnedBox, bounds) == 0 && offsetof(TurnedBox, source) == 12 &&
                  offsetof(TurnedBox, matrix) == 16 && offsetof(TurnedBox, starts) == 20,
              "what the assembly below takes them to be");
static_assert(sizeof(SplitRow) == 12 && sizeof(BoundStart) == 8 && kSplitBits == 14,
              "what the assembly below takes them to be");

/// 0 if a turned box, kept by turn_and_compare(), overlaps `other`. The four bytes behind each are
/// read, too, and ignored.
inline uint32_t compare(const PackedBox& kept, const PackedBox& other) {
  struct Vector {
    uint32_t word[4];
  };
  uint32_t gap;
  __asm__(
      "vldrw.u32 q0, %E1\n\t"
      "vldrw.u32 q1, %E2\n\t"
      "vqadd.u16 q0, q0, q1\n\t"
      "vcmp.s16 ge, q0, zr\n\t"
      "vmrs %0, p0\n\t"
      "lsl %0, %0, #20"
      : "=r"(gap)
      : "Ux"(reinterpret_cast<const Vector&>(kept)), "Ux"(reinterpret_cast<const Vector&>(other))
      : "q0", "q1", "p0");
  return gap;
}

/// Turns `box` and keeps it; 0 if it overlaps `other`. 35 instructions.
///
/// r0 turned, r1 box, r2 other; r5 rows, r3 starts; q0 the box, q1 with upper and lower exchanged;
/// q2, q3 rows; r4, r6, r8, r10, r12, lr the upper and lower x, y and z.
[[gnu::naked, gnu::noinline]] static uint32_t turn_and_compare(TurnedBox& /*turned*/,
                                                               const PackedBox& /*box*/,
                                                               const PackedBox& /*other*/) {
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
      "vldrw.u32 q3, [r2]\n\t"
      "vmladava.s16 r12, q2, q0\n\t"
      "vmladava.s16 lr, q2, q1\n\t"
      // Lower x, y, upper x, y, lower z, upper z: the sums with another box need no exchange.
      "vmov q0[3], q0[1], r4, r4\n\t"
      "vmov q1[3], q1[1], r8, r8\n\t"
      "vmov q1[2], q1[0], r10, r12\n\t"
      "vmov q0[2], q0[0], r6, lr\n\t"
      ".inst.w 0xEE924FC0\n\t"  // vqshrunb.s32 q2, q0, #14
      ".inst.w 0xEE925FC2\n\t"  // vqshrunt.s32 q2, q1, #14
      "vqadd.u16 q3, q3, q2\n\t"
      "vstrw.32 q2, [r0]\n\t"
      "vcmp.s16 ge, q3, zr\n\t"
      "str r1, [r0, #12]\n\t"
      "vmrs r0, p0\n\t"
      "lsls r0, r0, #20\n\t"
      "pop {r4, r5, r6, r8, r10, pc}");
}

}  // namespace flashbvh

#endif
