// Written by tools/figures.sh, from what proofs/time proved for GCC 12 at -O2.
#ifndef FLASHBVH_DETAIL_WALK_RUN_COSTS_HPP
#define FLASHBVH_DETAIL_WALK_RUN_COSTS_HPP

#include "flashbvh/plain/results.h"

namespace flashbvh {

using RunCosts = flashbvh_run_costs;

constexpr RunCosts kCortexM0 = {8408, 32, 12, 176, 753};
constexpr RunCosts kCortexM3 = {3325, 24, 12, 108, 228};
constexpr RunCosts kCortexM33 = {2880, 24, 12, 88, 184};
constexpr RunCosts kCortexM4F = {2869, 23, 12, 88, 184};
constexpr RunCosts kCortexM55 = {2867, 24, 12, 86, 183};
constexpr RunCosts kCortexM7 = {2906, 24, 12, 88, 188};
constexpr RunCosts kRV32IMAC = {4138, 21, 10, 108, 399};

}  // namespace flashbvh

#endif
