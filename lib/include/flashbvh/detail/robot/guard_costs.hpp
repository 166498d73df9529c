// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 217428, 6012, 11, 1535, 284, 143, 15847, 32, 139865, 5705) \
  core(CortexM3, cortex_m3, "Cortex-M3", 67887, 828, 9, 857, 87, 77, 14850, 377, 18820, 1136) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 55874, 842, 9, 854, 86, 76, 10668, 23, 19010, 1062) \
  core(CortexM7, cortex_m7, "Cortex-M7", 55822, 840, 9, 855, 85, 77, 10781, 24, 19072, 1069) \
  core(CortexM33, cortex_m33, "Cortex-M33", 56309, 833, 9, 857, 87, 77, 10715, 24, 19005, 1065) \
  core(CortexM55, cortex_m55, "Cortex-M55", 56532, 800, 9, 877, 97, 77, 10701, 24, 18832, 1044) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 83477, 1174, 9, 1079, 121, 132, 16788, 21, 25263, 1490)
// clang-format on

#endif
