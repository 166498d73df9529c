// The inner step of the rotated box test for Armv7E-M and Armv8-M Mainline cores with the DSP
// extension: the arithmetic of portable/rotate_box.hpp with several words per load (LDM, LDRD),
// which compilers do not find. In C++ a query takes more instructions.
#pragma once

#include "../assembly.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

/// Rotates `box` and keeps it; 0 if it overlaps `other`. 47 instructions.
///
/// r0 rotated, r1 box, then rows, r2 other, r3 starts; r4, r5, r6 the box's words; r7, r8, r9 a
/// row's; r10, r11 upper and lower x and y; r12, lr the current bounds.
[[gnu::naked, gnu::noinline]] static uint32_t rotate_and_compare(RotatedBox& /*rotated*/,
                                                                 const PackedBox& /*box*/,
                                                                 const PackedBox& /*other*/) {
  __asm__(R"(
    @ An axis: two sums of three pairs of products, then whole cells from 0 to 32,767. The row r1
    @ and the starts r3 move on.
    .macro rotate_axis upper, lower
    ldm r1!, {r7, r8, r9}
    ldrd \upper, \lower, [r3], #8
    smlad \upper, r7, r4, \upper
    smlad \lower, r7, r5, \lower
    smlad \upper, r8, r5, \upper
    smlad \lower, r8, r4, \lower
    smlad \upper, r9, r6, \upper
    smladx \lower, r9, r6, \lower
    usat \upper, #15, \upper, asr #14
    usat \lower, #15, \lower, asr #14
    .endm

    push {r4, r5, r6, r7, r8, r9, r10, r11, lr}
    ldm r1, {r4, r5, r6}
    str r1, [r0, #12]
    ldrd r1, r3, [r0, #16]
    rotate_axis r10, r11
    rotate_axis r12, lr
    orr r10, r10, r12, lsl #16
    orr r11, r11, lr, lsl #16
    rotate_axis r12, lr
    orr r12, r12, lr, lsl #16
    stm r0, {r10, r11, r12}
    ldm r2, {r4, r5, r6}
    add r4, r4, r11
    add r5, r5, r10
    add r6, r6, r12, ror #16
    and r4, r4, r5
    and r4, r4, r6
    mov r0, #0x80008000
    bic r0, r0, r4
    pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}

    .purgem rotate_axis
  )");
}

}  // namespace flashbvh::detail
