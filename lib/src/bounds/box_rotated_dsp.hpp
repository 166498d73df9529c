// The inner step of the rotated box test for Armv7E-M and Armv8-M Mainline cores with the DSP
// extension: the arithmetic of box_rotated.cpp, with what compilers do not find: several words in
// one load (LDM, LDRD), all of them in registers to the end, and a shift inside a saturation
// (USAT).
#ifndef FLASHBVH_BOUNDS_BOX_ROTATED_DSP_HPP
#define FLASHBVH_BOUNDS_BOX_ROTATED_DSP_HPP

#include "box_rotated_layout.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"
#include "rotate_sums_dsp.hpp"

namespace flashbvh::detail {

/// Rotates `box` and keeps it; 0 if it overlaps `other`. 47 instructions.
///
/// r0 rotated, r1 box, then rows, r2 other, r3 starts; r4, r5, r6 the box's words; r7, r8, r9 a
/// row's; r10, r11 upper and lower x and y; r12, lr the current bounds.
[[gnu::naked, gnu::noinline]] static uint32_t rotate_and_compare(RotatedBox& /*rotated*/,
                                                                 const PackedBox& /*box*/,
                                                                 const PackedBox& /*other*/) {
  // An axis: two sums of three pairs of products, then whole cells from 0 to 32,767.
#define FLASHBVH_ROTATE_AXIS(upper, lower) \
  FLASHBVH_ROTATE_SUMS(upper, lower)       \
  "usat " upper ", #15, " upper            \
  ", asr #14\n\t"                          \
  "usat " lower ", #15, " lower ", asr #14\n\t"
  __asm__(
      "push {r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"
      "ldm r1, {r4, r5, r6}\n\t"
      "str r1, [r0, #12]\n\t"
      "ldrd r1, r3, [r0, #16]\n\t"
      FLASHBVH_ROTATE_AXIS("r10", "r11")
      FLASHBVH_ROTATE_AXIS("r12", "lr")
      "orr r10, r10, r12, lsl #16\n\t"
      "orr r11, r11, lr, lsl #16\n\t"
      FLASHBVH_ROTATE_AXIS("r12", "lr")
      "orr r12, r12, lr, lsl #16\n\t"
      "stm r0, {r10, r11, r12}\n\t"
      "ldm r2, {r4, r5, r6}\n\t"
      "add r4, r4, r11\n\t"
      "add r5, r5, r10\n\t"
      "add r6, r6, r12, ror #16\n\t"
      "and r4, r4, r5\n\t"
      "and r4, r4, r6\n\t"
      "mov r0, #0x80008000\n\t"
      "bic r0, r0, r4\n\t"
      "pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}");
#undef FLASHBVH_ROTATE_AXIS
}

}  // namespace flashbvh::detail

#endif
