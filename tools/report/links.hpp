// HTML names of a robot's links, joints, and pairs that no guard tests.
#pragma once

#include <string>
#include <vector>

#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// Two links: "upper - fore".
std::string links_of(const Model& model, std::size_t a, std::size_t b);

/// "elbow 1.5, wrist 0", with one value per variable.
std::string joint_values(const Model& model, const std::vector<double>& values);

/// " data-values=...": the values that the page's robot takes; empty without values.
std::string shown_values(const std::vector<double>& values);

/// One line per reason: "Not guarded: base - arm (neighbours that ...)"; empty if there are none.
std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded);

}  // namespace flashbvh::tool
