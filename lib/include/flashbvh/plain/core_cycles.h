/* Each core's names as in core_costs.h, and its flashbvh_run_cycles and GuardCycles: cycles, then
 * reads of flash. Written by tools/figures.sh; proven by proofs/time for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_CORE_CYCLES_H
#define FLASHBVH_PLAIN_CORE_CYCLES_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE_IN_CYCLES(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", {18253, 52, 18, 1159, 2661}, {7055, 40, 14, 173, 517}) \
  core(CortexM0Fast, cortex_m0_fast, "Cortex-M0-Fast", {11525, 52, 18, 322, 1094}, {7055, 40, 14, 173, 517}) \
  core(CortexM0Plus, cortex_m0plus, "Cortex-M0+", {17834, 46, 16, 1146, 2626}, {7055, 40, 14, 173, 517}) \
  core(CortexM0PlusFast, cortex_m0plus_fast, "Cortex-M0+-Fast", {11095, 46, 16, 309, 1058}, {7055, 40, 14, 173, 517}) \
  core(CortexM3, cortex_m3, "Cortex-M3", {6960, 46, 22, 271, 602}, {3484, 35, 15, 120, 345}) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", {5928, 46, 20, 204, 388}, {3195, 35, 14, 111, 225})

#define FLASHBVH_FOR_EACH_GUARD_CORE_IN_CYCLES(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", {548721, 26054, 15, 10791, 4300, 313, 0, 51, 500332, 19206}, {114002, 3084, 13, 2868, 624, 167, 0, 36, 91161, 3515}) \
  core(CortexM0Fast, cortex_m0_fast, "Cortex-M0-Fast", {246618, 8570, 15, 6482, 1696, 282, 0, 51, 214714, 8388}, {114002, 3084, 13, 2868, 624, 167, 0, 36, 91161, 3515}) \
  core(CortexM0Plus, cortex_m0plus, "Cortex-M0+", {539158, 25821, 14, 10517, 4260, 290, 0, 46, 493535, 18945}, {114002, 3084, 13, 2868, 624, 167, 0, 36, 91161, 3515}) \
  core(CortexM0PlusFast, cortex_m0plus_fast, "Cortex-M0+-Fast", {236967, 8337, 14, 6208, 1656, 259, 0, 46, 206285, 8068}, {114002, 3084, 13, 2868, 624, 167, 0, 36, 91161, 3515}) \
  core(CortexM3, cortex_m3, "Cortex-M3", {138801, 1937, 15, 4179, 690, 226, 18998, 795, 44907, 2963}, {62279, 662, 11, 1989, 270, 134, 8374, 319, 16751, 1335}) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", {104918, 1397, 15, 3940, 573, 226, 16858, 46, 36191, 2054}, {55165, 663, 11, 1977, 268, 135, 8581, 35, 16665, 1101})
/* clang-format on */

#endif
