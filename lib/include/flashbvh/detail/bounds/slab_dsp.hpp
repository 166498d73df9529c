// A box against a window and two slabs, for cores with the DSP extension (Cortex-M4, M7, M33, M55):
// the arithmetic of packed.hpp and slab.hpp, with what compilers do not find: several words in one
// load (LDM), and all of a slab's in registers. Other cores have it as it is defined.
#ifndef FLASHBVH_DETAIL_BOUNDS_SLAB_DSP_HPP
#define FLASHBVH_DETAIL_BOUNDS_SLAB_DSP_HPP

#include <stddef.h>

#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/bounds/slab_simd.hpp"

namespace flashbvh::detail {

/// What a leaf as a shape holds against boxes.
struct BoxTests {
  PackedTriple window;
  Slab plane;
  Slab edge;
};

// Where nothing is optimised there are too few registers.
#if defined(__ARM_FEATURE_DSP) && defined(__thumb2__) && defined(__OPTIMIZE__) && \
    !defined(FLASHBVH_PORTABLE)

// A slab, 11 instructions. r4, r8, r9 the box's words; r0, r1, r2 the row's; r3, r12 what its
// bounds have to reach.
#define FLASHBVH_TEST_SLAB(slab, sum, apart) \
  "ldm " slab                                \
  ", {r0, r1, r2, r3, r12}\n\t"              \
  "smuad " sum                               \
  ", r0, r4\n\t"                             \
  "smlad " sum ", r1, r8, " sum              \
  "\n\t"                                     \
  "smlad " sum ", r2, r9, " sum              \
  "\n\t"                                     \
  "cmp " sum                                 \
  ", r3\n\t"                                 \
  "blt " apart                               \
  "\n\t"                                     \
  "smuad " sum                               \
  ", r0, r8\n\t"                             \
  "smlad " sum ", r1, r4, " sum              \
  "\n\t"                                     \
  "smladx " sum ", r2, r9, " sum             \
  "\n\t"                                     \
  "cmp " sum                                 \
  ", r12\n\t"                                \
  "blt " apart "\n\t"

static_assert(offsetof(BoxTests, plane) == 12 && offsetof(BoxTests, edge) == 32 &&
                  sizeof(Slab) == 20,
              "loaded one after the other");

/// False only if the box misses the window or has no point in one of the slabs.
FLASHBVH_INLINE inline bool may_touch_all(const BoxTests& tests, const PackedBox& box) {
  __asm__ goto(
      "ldm %1, {r4, r8, r9}\n\t"
      "mov lr, %0\n\t"
      "ldm lr!, {r0, r1, r2}\n\t"
      "uqsub16 r0, r0, r4\n\t"
      "uqsub16 r1, r1, r8\n\t"
      "uqsub16 r2, r2, r9\n\t"
      "orr r0, r0, r1\n\t"
      "orrs r0, r0, r2\n\t"
      "bne %l[apart]\n\t" FLASHBVH_TEST_SLAB("lr!", "r10", "%l[apart]")
          FLASHBVH_TEST_SLAB("lr!", "r10", "%l[apart]")
      :
      : "r"(&tests), "r"(&box)
      : "r0", "r1", "r2", "r3", "r4", "r8", "r9", "r10", "r12", "lr", "cc", "memory"
      : apart);
  return true;
apart:
  return false;
}

/// False only if the box has no point in the slab.
FLASHBVH_INLINE inline bool may_touch_one(const Slab& slab, const PackedBox& box) {
  __asm__ goto("ldm %1, {r4, r8, r9}\n\t" FLASHBVH_TEST_SLAB("%0", "lr", "%l[apart]")
               :
               : "r"(&slab), "r"(&box)
               : "r0", "r1", "r2", "r3", "r4", "r8", "r9", "r12", "lr", "cc", "memory"
               : apart);
  return true;
apart:
  return false;
}

#undef FLASHBVH_TEST_SLAB

#else

FLASHBVH_INLINE inline bool may_touch_all(const BoxTests& tests, const PackedBox& box) {
  return halves_reach({{box.upper_xy, box.lower_xy, box.z}}, tests.window) &&
         may_touch_both(tests.plane, tests.edge, box);
}
FLASHBVH_INLINE inline bool may_touch_one(const Slab& slab, const PackedBox& box) {
  return slab.may_touch(box);
}

#endif

}  // namespace flashbvh::detail

#endif
