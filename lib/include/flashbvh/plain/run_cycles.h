/* Each core's names as in run_costs.h, and its RunCycles: cycles, then reads of flash.
 * tools/figures.sh writes them, and proofs/time proves them for GCC 12 at -O2. */
#ifndef FLASHBVH_PLAIN_RUN_CYCLES_H
#define FLASHBVH_PLAIN_RUN_CYCLES_H

/* clang-format off */
#define FLASHBVH_FOR_EACH_CORE_IN_CYCLES(core) \
  core(CortexM0, cortex_m0, "Cortex-M0", {18253, 52, 18, 1159, 2661}, {7055, 40, 14, 173, 517}) \
  core(CortexM0Fast, cortex_m0_fast, "Cortex-M0-Fast", {11525, 52, 18, 322, 1094}, {7055, 40, 14, 173, 517}) \
  core(CortexM0Plus, cortex_m0plus, "Cortex-M0+", {17834, 46, 16, 1146, 2626}, {7055, 40, 14, 173, 517}) \
  core(CortexM0PlusFast, cortex_m0plus_fast, "Cortex-M0+-Fast", {11095, 46, 16, 309, 1058}, {7055, 40, 14, 173, 517}) \
  core(CortexM3, cortex_m3, "Cortex-M3", {6960, 46, 22, 271, 602}, {3484, 35, 15, 120, 345}) \
  core(CortexM4F, cortex_m4f, "Cortex-M4F", {5928, 46, 20, 204, 388}, {3195, 35, 14, 111, 225})

#endif
