// The inner step of the rotated box test for Armv6-M and Armv8-M Baseline cores (Cortex-M0, M0+,
// M23). Computes as plain/rotate_box.hpp does, in the eight low registers of Thumb-1.
// The box's bounds are loaded for each product: this takes no more instructions than a copy from a
// high register and needs no spill. Compilers do not find this form.
#pragma once

#include "../assembly.hpp"
#include "flashbvh/detail/bounds/box_rotated.hpp"

namespace flashbvh::detail {

/// Clamps the sums in r4 and r5, so that whole cells are 0 to 32,767. Changes r6.
extern "C" [[FLASHBVH_CALLED_BY_NAME]] void flashbvh_clamp_sums() {
  __asm__(R"(
    .syntax unified  @ compilers set the older one for Thumb-1
    .macro clamp sum
    asrs r6, \sum, #29
    beq 5f
    asrs \sum, \sum, #31
    mvns \sum, \sum
    lsrs \sum, \sum, #3
  5:
    .endm

    clamp r4
    clamp r5
    bx lr

    .purgem clamp
  )");
}

/// Rotates `box` and stores it in `rotated`; 0 if it overlaps `other`. 136 instructions, and some
/// 10 for each axis with a bound outside the lattice.
///
/// r0 rotated, r1 box, then rows, r2 other, then box, r3 starts; r4, r5 current upper and lower
/// bound; r6 an entry; r7 a product; r12 other.
[[gnu::naked, gnu::noinline]] static uint32_t rotate_and_compare(RotatedBox& /*rotated*/,
                                                                 const PackedBox& /*box*/,
                                                                 const PackedBox& /*other*/) {
  __asm__(R"(
    .syntax unified
    .macro add_products upper, lower
    ldrh r7, [r2, #\upper]
    muls r7, r6
    adds r4, r7
    ldrh r7, [r2, #\lower]
    muls r7, r6
    adds r5, r7
    .endm
    @ Adds an entry's products: its positive part's or, where that is zero, the other one's.
    .macro rotate_entry positive, negative, upper, lower
    ldrh r6, [r1, #\positive]
    cmp r6, #0
    beq 1f
    add_products \upper, \lower
    b 2f
  1:
    ldrh r6, [r1, #\negative]
    add_products \lower, \upper
  2:
    .endm
    @ Two sums of three products, then whole cells from 0 to 32,767.
    .macro rotate_axis row, upper, lower
    ldm r3!, {r4, r5}
    rotate_entry \row + 0, \row + 4, 0, 4
    rotate_entry \row + 2, \row + 6, 2, 6
    rotate_entry \row + 8, \row + 10, 8, 10
    movs r6, r4
    orrs r6, r5
    lsrs r6, r6, #29
    beq 3f
    bl flashbvh_clamp_sums
  3:
    lsrs r4, r4, #14
    lsrs r5, r5, #14
    strh r4, [r0, #\upper]
    strh r5, [r0, #\lower]
    .endm
    push {r4, r5, r6, r7, lr}
    mov r12, r2
    mov r2, r1
    str r1, [r0, #12]
    ldr r3, [r0, #20]
    ldr r1, [r0, #16]
    rotate_axis 0, 0, 4
    rotate_axis 12, 2, 6
    rotate_axis 24, 8, 10
    ldm r0!, {r4, r5, r6}
    mov r1, r12
    ldm r1, {r1, r2, r3}
    adds r4, r2
    adds r5, r1
    movs r7, #16
    rors r3, r7
    adds r6, r3
    ands r4, r5
    ands r4, r6
    ldr r0, 9f
    bics r0, r4
    pop {r4, r5, r6, r7, pc}

    .balign 4
  9:
    .word 0x80008000
    .purgem add_products
    .purgem rotate_entry
    .purgem rotate_axis
  )");
}

}  // namespace flashbvh::detail
