// The inner step of the rotated gap for Armv7E-M and Armv8-M Mainline cores with the DSP extension:
// the arithmetic of gap.cpp, with what compilers do not find, as box_rotated_dsp.hpp has it.
#ifndef FLASHBVH_BOUNDS_GAP_DSP_HPP
#define FLASHBVH_BOUNDS_GAP_DSP_HPP

#include <stddef.h>

#include "flashbvh/detail/bounds/gap.hpp"
#include "rotate_sums_dsp.hpp"

namespace flashbvh::detail {

static_assert(offsetof(NearBox, window) == 0 && offsetof(NearBox, source) == 12 &&
              offsetof(NearBox, matrix) == 16 && offsetof(NearBox, starts) == 20 &&
              offsetof(NearBox, zero) == 24 && offsetof(NearBox, limit) == 28);
static_assert(sizeof(SplitRow) == 12 && sizeof(BoxTestStart) == 8 && kSplitBits == 14);

/// Whether `box` is within the limit of the current box, if that is not null; if so, rotates it and
/// keeps it: whether `other` is within the limit of that. 11 and 61 instructions.
///
/// r0 kept, r1 box, then rows, r2 what sums are subtracted from, then other, r3 current, then
/// starts; r4, r5, r6 the box's words; r7, r8, r9 a row's; r10, r11 what upper and lower x and y
/// are to reach; r12, lr the current bounds.
[[gnu::naked, gnu::noinline]] static bool rotate_near(NearBox& /*kept*/, const PackedBox& /*box*/,
                                                      const PackedBox& /*other*/,
                                                      const NearBox* /*at_hand*/) {
  // An axis: two sums of three pairs of products, then what is missing to them, from 0 to 65,535.
#define FLASHBVH_ROTATE_AXIS(upper, lower) \
  FLASHBVH_ROTATE_SUMS(upper, lower)       \
  "sub " upper ", r2, " upper              \
  "\n\t"                                   \
  "sub " lower ", r2, " lower              \
  "\n\t"                                   \
  "usat " upper ", #16, " upper            \
  ", asr #14\n\t"                          \
  "usat " lower ", #16, " lower ", asr #14\n\t"
  // What is missing of a box, r7, r8, r9, to a window; on to 1 if it is too much.
#define FLASHBVH_COMPARE(upper_xy, lower_xy, z, limit_of) \
  "uqsub16 r4, " upper_xy                                 \
  ", r7\n\t"                                              \
  "uqsub16 r5, " lower_xy                                 \
  ", r8\n\t"                                              \
  "uqsub16 r6, " z                                        \
  ", r9\n\t"                                              \
  "orr r4, r4, r5\n\t"                                    \
  "orr r5, r4, r6\n\t"                                    \
  "tst r5, #0x80008000\n\t"                               \
  "bne 1f\n\t"                                            \
  "ldr r7, [" limit_of                                    \
  ", #28]\n\t"                                            \
  "smuad r4, r4, r4\n\t"                                  \
  "smlad r4, r6, r6, r4\n\t"                              \
  "cmp r7, r4\n\t"
  __asm__(
      "push {r2, r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"
      "cbz r3, 2f\n\t"
      "ldm r3, {r4, r5, r6}\n\t"
      "ldm r1, {r7, r8, r9}\n\t"
      FLASHBVH_COMPARE("r4", "r5", "r6", "r3")
      "blo 1f\n\t"
      "2:\n\t"
      "ldm r1, {r4, r5, r6}\n\t"
      "str r1, [r0, #12]\n\t"
      "ldrd r1, r3, [r0, #16]\n\t"
      "ldr r2, [r0, #24]\n\t"
      // What a seen upper bound is missing, a box's lower one has to reach.
      FLASHBVH_ROTATE_AXIS("r11", "r10")
      FLASHBVH_ROTATE_AXIS("lr", "r12")
      "orr r10, r10, r12, lsl #16\n\t"
      "orr r11, r11, lr, lsl #16\n\t"
      FLASHBVH_ROTATE_AXIS("lr", "r12")
      "orr r12, r12, lr, lsl #16\n\t"
      "stm r0, {r10, r11, r12}\n\t"
      "ldr r2, [sp]\n\t"
      "ldm r2, {r7, r8, r9}\n\t"
      FLASHBVH_COMPARE("r10", "r11", "r12", "r0")
      "blo 1f\n\t"
      "mov r0, #1\n\t"
      "pop {r2, r4, r5, r6, r7, r8, r9, r10, r11, pc}\n\t"
      "1:\n\t"
      "mov r0, #0\n\t"
      "pop {r2, r4, r5, r6, r7, r8, r9, r10, r11, pc}");
#undef FLASHBVH_COMPARE
#undef FLASHBVH_ROTATE_AXIS
}

}  // namespace flashbvh::detail

#endif
