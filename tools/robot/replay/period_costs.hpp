// The parts of the instructions of a guard's period. tools/figures.sh measures a KR5 and writes
// them.
#pragma once

#include <map>
#include <string>

namespace flashbvh::tool {

struct PeriodCosts {
  const char* core;
  double period;   ///< without joints, pairs or work
  double joint;    ///< more for each joint, ...
  double pair;     ///< ... each pair ...
  double between;  ///< ... and each joint between the links of a pair
  double frames;   ///< of six joints' frames, which a period with any work makes
  double work;     ///< of a unit: the most in periods with 150 or more
};
/// By core, spelt as presets are.
const std::map<std::string, PeriodCosts> kPeriodCosts = {
    {"cortex-m3", {"Cortex-M3", 167, 81, 236, 27, 2302, 262}},
    {"cortex-m4f", {"Cortex-M4F", 167, 81, 238, 26, 2332, 234}},
    {"rv32imac", {"RV32IMAC", 267, 81, 237, 34, 3552, 341}},
};

}  // namespace flashbvh::tool
