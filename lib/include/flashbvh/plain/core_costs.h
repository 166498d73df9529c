/* Each core's names in C++, in C and in documents, and its costs:
 * flashbvh_run_costs, and the GuardCosts of robot/period_bound.hpp. Written by tools/figures.sh;
 * proven by proofs/time for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_CORE_COSTS_H
#define FLASHBVH_PLAIN_CORE_COSTS_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 8651, 32, 12, 251, 761) \
  core(CortexM3, cortex_m3, "Cortex-M3", 3479, 24, 12, 159, 233) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 3012, 23, 12, 130, 189) \
  core(CortexM7, cortex_m7, "Cortex-M7", 3037, 24, 12, 130, 192) \
  core(CortexM33, cortex_m33, "Cortex-M33", 3014, 24, 12, 130, 189) \
  core(CortexM55, cortex_m55, "Cortex-M55", 3006, 24, 12, 128, 187) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 4293, 21, 10, 159, 404)

#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 174524, 6011, 11, 4314, 1204, 185, 0, 32, 139875, 5555) \
  core(CortexM3, cortex_m3, "Cortex-M3", 70053, 828, 9, 2079, 318, 120, 9027, 397, 18814, 1529) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 54831, 842, 9, 2065, 322, 120, 9032, 23, 19005, 1057) \
  core(CortexM7, cortex_m7, "Cortex-M7", 54623, 840, 9, 2084, 312, 122, 8857, 24, 19067, 1061) \
  core(CortexM33, cortex_m33, "Cortex-M33", 54917, 833, 9, 2079, 318, 120, 9103, 24, 18999, 1055) \
  core(CortexM55, cortex_m55, "Cortex-M55", 55215, 800, 9, 2121, 340, 120, 9157, 24, 18825, 1060) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 79177, 1174, 9, 2399, 402, 148, 11973, 21, 25263, 1615)
/* clang-format on */

#endif
