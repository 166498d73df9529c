// Each core's GuardCosts, by the names in plain/run_costs.h: written by tools/figures.sh, proven by
// proofs/time for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP
#define FLASHBVH_DETAIL_ROBOT_GUARD_COSTS_HPP

// clang-format off
#define FLASHBVH_FOR_EACH_GUARD_CORE(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", 217491, 6012, 11, 1556, 284, 150, 15868, 32, 139865, 5705) \
  core(CortexM3, cortex_m3, "Cortex-M3", 68139, 828, 9, 941, 87, 105, 14934, 377, 18820, 1136) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", 56135, 842, 9, 941, 86, 105, 10755, 23, 19010, 1062) \
  core(CortexM7, cortex_m7, "Cortex-M7", 56083, 840, 9, 942, 85, 106, 10868, 24, 19072, 1069) \
  core(CortexM33, cortex_m33, "Cortex-M33", 56561, 833, 9, 941, 87, 105, 10799, 24, 19005, 1065) \
  core(CortexM55, cortex_m55, "Cortex-M55", 56784, 800, 9, 961, 97, 105, 10785, 24, 18832, 1044) \
  core(RV32IMAC, rv32imac, "RV32IMAC", 83621, 1174, 9, 1127, 121, 148, 16836, 21, 25263, 1490)
// clang-format on

#endif
