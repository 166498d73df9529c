/* Each core's names in C++, in C and in documents, and its costs:
 * flashbvh_run_costs, and the GuardCosts of robot/period_bound.hpp. Written by tools/figures.sh;
 * proven by proofs/time for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_CORE_COSTS_H
#define FLASHBVH_PLAIN_CORE_COSTS_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 8659, 32, 12, 251, 762) \
  core(CortexM3, cortex_m3, "Cortex-M3", 3486, 24, 12, 159, 238) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 3019, 23, 12, 130, 189) \
  core(CortexM7, cortex_m7, "Cortex-M7", 3044, 24, 12, 130, 193) \
  core(CortexM33, cortex_m33, "Cortex-M33", 3021, 24, 12, 130, 189) \
  core(CortexM55, cortex_m55, "Cortex-M55", 3008, 24, 12, 128, 187) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 4293, 21, 10, 159, 404)

#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 170664, 6013, 11, 4314, 1204, 185, 0, 32, 139875, 5534) \
  core(CortexM3, cortex_m3, "Cortex-M3", 68461, 822, 9, 2079, 318, 120, 9045, 397, 18814, 1477) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 54959, 843, 9, 2065, 322, 120, 9094, 23, 19005, 1056) \
  core(CortexM7, cortex_m7, "Cortex-M7", 54797, 834, 9, 2084, 312, 122, 8925, 24, 19067, 1061) \
  core(CortexM33, cortex_m33, "Cortex-M33", 55081, 827, 9, 2079, 318, 120, 9167, 24, 18999, 1055) \
  core(CortexM55, cortex_m55, "Cortex-M55", 55566, 803, 9, 2121, 340, 120, 9298, 24, 18825, 1061) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 77021, 1176, 9, 2399, 402, 148, 11838, 21, 25263, 1555)
/* clang-format on */

#endif
