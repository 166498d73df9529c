/* Each core's names in C++, in C and in documents, and its RunCosts: written by tools/figures.sh,
 * proven by proofs/time for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_RUN_COSTS_H
#define FLASHBVH_PLAIN_RUN_COSTS_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 8418, 32, 12, 176, 753) \
  core(CortexM3, cortex_m3, "Cortex-M3", 3329, 24, 12, 108, 228) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 2879, 23, 12, 88, 184) \
  core(CortexM7, cortex_m7, "Cortex-M7", 2908, 24, 12, 88, 188) \
  core(CortexM33, cortex_m33, "Cortex-M33", 2884, 24, 12, 88, 184) \
  core(CortexM55, cortex_m55, "Cortex-M55", 2871, 24, 12, 86, 183) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 4143, 21, 10, 108, 399)

#endif
