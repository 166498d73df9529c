// What flashbvh guard prints of a trajectory, in parts that text and JSON share.
#pragma once

#include <optional>
#include <string>

#include "report/guard_page.hpp"

namespace flashbvh::tool {

/// "ok", or the status' name.
std::string name_of(Status status);
const std::string& link_name(const GuardedTrajectory& guarded, std::uint8_t link);
const std::string& variable_name(const GuardedTrajectory& guarded, std::size_t variable);

/// In metres: how far a point of a link may lie from the meshes that it was baked of.
double links_deviation(const Robot& robot);

/// What is wrong with the values of a period, and how to fix it.
std::string why_refused(const GuardedTrajectory& guarded, std::size_t period);

/// What is guarded, and how well.
void print_head(const GuardedTrajectory& guarded);

/// One object a line of the trajectory; the first holds facts about the whole trajectory, too.
void print_guarded_json(const GuardedTrajectory& guarded);

/// A table: the instructions of periods on a core, and the work that they need.
void print_timing(const GuardTiming& timing);

}  // namespace flashbvh::tool
