// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 217806, 6012, 11, 1661, 284, 185, 15973, 32, 139865, 5705) \
  core(CortexM3, cortex_m3, "Cortex-M3", 68283, 828, 9, 989, 87, 120, 14982, 377, 18820, 1136) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 56279, 842, 9, 989, 86, 120, 10803, 23, 19010, 1062) \
  core(CortexM7, cortex_m7, "Cortex-M7", 56218, 840, 9, 987, 85, 122, 10913, 24, 19072, 1069) \
  core(CortexM33, cortex_m33, "Cortex-M33", 56705, 833, 9, 989, 87, 120, 10847, 24, 19005, 1065) \
  core(CortexM55, cortex_m55, "Cortex-M55", 56928, 800, 9, 1009, 97, 120, 10833, 24, 18832, 1044) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 83621, 1174, 9, 1127, 121, 148, 16836, 21, 25263, 1490)
// clang-format on

#endif
