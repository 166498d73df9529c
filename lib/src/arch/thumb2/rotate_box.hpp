// The inner step of the rotated box test for Armv7-M and Armv8-M Mainline cores without the DSP
// extension (Cortex-M3): the arithmetic of plain/rotate_box.hpp, with a branch on 0 in one
// instruction (CBZ), a shift inside a saturation (USAT) and all sums in registers. In C++ a
// query takes more instructions.
#pragma once

#include "../assembly.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

/// Rotates `box` and keeps it; 0 if it overlaps `other`. 77 instructions.
///
/// r0 rotated, r1 box, then rows, r2 other, then an entry, r3 starts; r4 and r5, r6 and r7, r8 and
/// r9 the box's bounds; r10, r11 upper and lower x and y; r12, lr the current bounds.
[[gnu::naked, gnu::noinline]] static uint32_t rotate_and_compare(RotatedBox& /*rotated*/,
                                                                 const PackedBox& /*box*/,
                                                                 const PackedBox& /*other*/) {
  __asm__(R"(
    @ Adds an entry's products: its positive part's or, where that is zero, the other one's.
    .macro rotate_entry positive, negative, upper, lower, box_upper, box_lower
    ldrh r2, [r1, #\positive]
    cbz r2, 1f
    mla \upper, r2, \box_upper, \upper
    mla \lower, r2, \box_lower, \lower
    b 2f
  1:
    ldrh r2, [r1, #\negative]
    mla \upper, r2, \box_lower, \upper
    mla \lower, r2, \box_upper, \lower
  2:
    .endm

    @ Two sums of three products, then whole cells from 0 to 32,767.
    .macro rotate_axis row, upper, lower
    ldrd \upper, \lower, [r3], #8
    rotate_entry \row + 0, \row + 4, \upper, \lower, r4, r5
    rotate_entry \row + 2, \row + 6, \upper, \lower, r6, r7
    rotate_entry \row + 8, \row + 10, \upper, \lower, r8, r9
    usat \upper, #15, \upper, asr #14
    usat \lower, #15, \lower, asr #14
    .endm

    push {r2, r4, r5, r6, r7, r8, r9, r10, r11, lr}
    ldrh r4, [r1, #0]
    ldrh r5, [r1, #4]
    ldrh r6, [r1, #2]
    ldrh r7, [r1, #6]
    ldrh r8, [r1, #8]
    ldrh r9, [r1, #10]
    str r1, [r0, #12]
    ldrd r1, r3, [r0, #16]
    rotate_axis 0, r10, r11
    rotate_axis 12, r12, lr
    orr r10, r10, r12, lsl #16
    orr r11, r11, lr, lsl #16
    rotate_axis 24, r12, lr
    orr r12, r12, lr, lsl #16
    stm r0, {r10, r11, r12}
    ldr r2, [sp], #4
    ldm r2, {r4, r5, r6}
    add r4, r4, r11
    add r5, r5, r10
    add r6, r6, r12, ror #16
    and r4, r4, r5
    and r4, r4, r6
    mov r0, #0x80008000
    bic r0, r0, r4
    pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}

    .purgem rotate_entry
    .purgem rotate_axis
  )");
}

}  // namespace flashbvh::detail
