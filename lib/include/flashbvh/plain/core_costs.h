/* Each core's names in C++, in C and in documents, and its flashbvh_run_costs. Written by
 * tools/figures.sh; proven by proofs/time for GCC 12 at -O2. */
#pragma once

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 9262, 32, 12, 314, 781) \
  core(CortexM3, cortex_m3, "Cortex-M3", 3899, 24, 12, 210, 237) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 3381, 23, 12, 172, 199) \
  core(CortexM7, cortex_m7, "Cortex-M7", 3388, 24, 12, 172, 203) \
  core(CortexM33, cortex_m33, "Cortex-M33", 3386, 24, 12, 172, 200) \
  core(CortexM55, cortex_m55, "Cortex-M55", 3413, 24, 12, 170, 199) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 4808, 21, 10, 210, 404)
/* clang-format on */
