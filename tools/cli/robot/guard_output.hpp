// Output of flashbvh guard about a trajectory, in parts that text and JSON share.
#pragma once

#include <optional>
#include <string>

#include "report/guard_page.hpp"

namespace flashbvh::tool {

/// "ok", or the name of the status.
std::string name_of(Status status);
const std::string& link_name(const GuardedTrajectory& guarded, std::uint8_t link);
const std::string& variable_name(const GuardedTrajectory& guarded, std::size_t variable);

/// The largest distance in metres of a point of a link from the meshes that it was baked from.
double links_deviation(const Robot& robot);

/// The error in the values of a period, and how to fix it.
std::string why_refused(const GuardedTrajectory& guarded, std::size_t period);

/// Prints an object per line of the trajectory; the first also contains facts about the whole.
void print_guarded_json(const GuardedTrajectory& guarded);

/// Prints a table of the instructions of periods on a core, and of the work that they need.
void print_timing(const GuardTiming& timing);

}  // namespace flashbvh::tool
