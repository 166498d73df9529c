// How pages name a robot's links, joints, and pairs that no guard looks at: HTML.
#pragma once

#include <string>
#include <vector>

#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// "upper - fore".
std::string links_of(const Model& model, std::size_t a, std::size_t b);

/// "elbow 1.5, wrist 0". A value a variable.
std::string joint_values(const Model& model, const std::vector<double>& values);

/// " data-values=...": the values that the robot in the page then has; nothing without values.
std::string shown_values(const std::vector<double>& values);

/// A line a reason: "Not guarded: base - arm (neighbours that ...)". Nothing if there are none.
std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded);

}  // namespace flashbvh::tool
