// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 154210, 6011, 11, 4314, 1204, 185, 0, 32, 139875, 5486) \
  core(CortexM3, cortex_m3, "Cortex-M3", 58105, 828, 9, 2079, 318, 120, 4029, 377, 18814, 1468) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 45735, 842, 9, 2065, 322, 120, 5044, 23, 19005, 1022) \
  core(CortexM7, cortex_m7, "Cortex-M7", 45695, 840, 9, 2084, 312, 122, 4905, 24, 19067, 1029) \
  core(CortexM33, cortex_m33, "Cortex-M33", 45967, 833, 9, 2079, 318, 120, 5140, 24, 18999, 1023) \
  core(CortexM55, cortex_m55, "Cortex-M55", 46531, 800, 9, 2121, 340, 120, 5631, 24, 18825, 1009) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 66739, 1174, 9, 2399, 402, 148, 6874, 21, 25263, 1545)
// clang-format on

#endif
