/* Each core's names in C++, C and documents, and its RunCosts: tools/figures.sh writes them, and
 * proofs/time proves them for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_RUN_COSTS_H
#define FLASHBVH_PLAIN_RUN_COSTS_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 8651, 32, 12, 251, 761) \
  core(CortexM3, cortex_m3, "Cortex-M3", 3479, 24, 12, 159, 233) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 3012, 23, 12, 130, 189) \
  core(CortexM7, cortex_m7, "Cortex-M7", 3037, 24, 12, 130, 192) \
  core(CortexM33, cortex_m33, "Cortex-M33", 3014, 24, 12, 130, 189) \
  core(CortexM55, cortex_m55, "Cortex-M55", 3006, 24, 12, 128, 187) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 4293, 21, 10, 159, 404)

#endif
