// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 152273, 6011, 11, 3711, 1026, 185, 0, 32, 139875, 5485) \
  core(CortexM3, cortex_m3, "Cortex-M3", 57290, 828, 9, 1830, 278, 120, 3874, 377, 18814, 1460) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 45196, 842, 9, 1816, 282, 120, 4883, 23, 19005, 1023) \
  core(CortexM7, cortex_m7, "Cortex-M7", 45147, 840, 9, 1850, 279, 122, 4748, 24, 19067, 1029) \
  core(CortexM33, cortex_m33, "Cortex-M33", 45394, 833, 9, 1830, 278, 120, 4962, 24, 18999, 1024) \
  core(CortexM55, cortex_m55, "Cortex-M55", 45812, 800, 9, 1836, 296, 120, 5414, 24, 18825, 1009) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 65743, 1174, 9, 2075, 363, 148, 6586, 21, 25263, 1542)
// clang-format on

#endif
