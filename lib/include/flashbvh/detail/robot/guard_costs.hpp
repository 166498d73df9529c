// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 127392, 6011, 11, 2098, 386, 185, 0, 32, 139875, 5476) \
  core(CortexM3, cortex_m3, "Cortex-M3", 51214, 828, 9, 1210, 123, 120, 1146, 377, 18814, 1460) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 39218, 842, 9, 1210, 122, 120, 2245, 23, 19005, 1020) \
  core(CortexM7, cortex_m7, "Cortex-M7", 38973, 840, 9, 1212, 117, 122, 2028, 24, 19067, 1026) \
  core(CortexM33, cortex_m33, "Cortex-M33", 39306, 833, 9, 1210, 123, 120, 2276, 24, 18999, 1021) \
  core(CortexM55, cortex_m55, "Cortex-M55", 39883, 800, 9, 1236, 136, 120, 2749, 24, 18825, 1009) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 58085, 1174, 9, 1375, 167, 148, 3107, 21, 25263, 1542)
// clang-format on

#endif
