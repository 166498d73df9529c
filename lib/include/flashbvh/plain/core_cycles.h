/* Each core's names as in core_costs.h, and its flashbvh_run_cycles and GuardCycles: cycles, then
 * reads of flash. Written by tools/figures.sh; proven by proofs/time for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_CORE_CYCLES_H
#define FLASHBVH_PLAIN_CORE_CYCLES_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE_IN_CYCLES(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", {18283, 52, 18, 1159, 2663}, {7084, 40, 14, 173, 528}) \
  core(CortexM0Fast, cortex_m0_fast, "Cortex-M0-Fast", {11555, 52, 18, 322, 1095}, {7084, 40, 14, 173, 528}) \
  core(CortexM0Plus, cortex_m0plus, "Cortex-M0+", {17858, 46, 16, 1146, 2627}, {7084, 40, 14, 173, 528}) \
  core(CortexM0PlusFast, cortex_m0plus_fast, "Cortex-M0+-Fast", {11119, 46, 16, 309, 1060}, {7084, 40, 14, 173, 528}) \
  core(CortexM3, cortex_m3, "Cortex-M3", {6969, 46, 22, 271, 616}, {3484, 35, 15, 120, 351}) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", {5936, 46, 20, 204, 401}, {3196, 35, 14, 111, 232})

#define FLASHBVH_FOR_EACH_GUARD_CORE_IN_CYCLES(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", {540066, 26058, 15, 10791, 4300, 313, 0, 51, 500332, 19199}, {110997, 3085, 13, 2868, 624, 167, 0, 36, 91161, 3511}) \
  core(CortexM0Fast, cortex_m0_fast, "Cortex-M0-Fast", {241683, 8574, 15, 6482, 1696, 282, 0, 51, 214714, 8361}, {110997, 3085, 13, 2868, 624, 167, 0, 36, 91161, 3511}) \
  core(CortexM0Plus, cortex_m0plus, "Cortex-M0+", {531021, 25825, 14, 10517, 4260, 290, 0, 46, 493535, 18938}, {110997, 3085, 13, 2868, 624, 167, 0, 36, 91161, 3511}) \
  core(CortexM0PlusFast, cortex_m0plus_fast, "Cortex-M0+-Fast", {232550, 8341, 14, 6208, 1656, 259, 0, 46, 206285, 8044}, {110997, 3085, 13, 2868, 624, 167, 0, 36, 91161, 3511}) \
  core(CortexM3, cortex_m3, "Cortex-M3", {137787, 1916, 15, 4179, 690, 226, 19174, 795, 44907, 2918}, {61727, 660, 11, 1989, 270, 134, 8424, 319, 16751, 1313}) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", {105336, 1410, 15, 3940, 573, 226, 16950, 46, 36191, 2059}, {55306, 665, 11, 1977, 268, 135, 8588, 35, 16665, 1103})
/* clang-format on */

#endif
