// The sums that a rotated box's bounds along an axis are made of, for cores with the DSP extension.
#ifndef FLASHBVH_BOUNDS_ROTATE_SUMS_DSP_HPP
#define FLASHBVH_BOUNDS_ROTATE_SUMS_DSP_HPP

/// Text of assembly: into the registers `upper` and `lower` two sums of three pairs of products,
/// from the axis's starts on. r1 the row, r3 the starts, both moved on; r4, r5, r6 the box's words;
/// r7, r8 and r9 take the row's. 8 instructions.
#define FLASHBVH_ROTATE_SUMS(upper, lower) \
  "ldm r1!, {r7, r8, r9}\n\t"              \
  "ldrd " upper ", " lower                 \
  ", [r3], #8\n\t"                         \
  "smlad " upper ", r7, r4, " upper        \
  "\n\t"                                   \
  "smlad " lower ", r7, r5, " lower        \
  "\n\t"                                   \
  "smlad " upper ", r8, r5, " upper        \
  "\n\t"                                   \
  "smlad " lower ", r8, r4, " lower        \
  "\n\t"                                   \
  "smlad " upper ", r9, r6, " upper        \
  "\n\t"                                   \
  "smladx " lower ", r9, r6, " lower "\n\t"

#endif
