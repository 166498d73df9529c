// Options that describe a robot, and the progress of its stages.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/progress.hpp"
#include "robot/pipeline/prepare.hpp"

namespace flashbvh::tool {

/// Declares the robot's file, its packages and --visual-too.
void add_described_options(CLI::App& command, const std::string& name, RobotRequest& request);
/// Declares --stop and --warn.
void add_distances(CLI::App& command, RobotRequest& request);
/// Declares all other options of baking.
void add_baking_options(CLI::App& command, RobotRequest& request);
/// Declares --believe.
void add_believe(CLI::App& command, RobotRequest& request, const std::string& what);
/// Declares --time. `late`: the fate of pairs undecided by then.
void add_time(CLI::App& command, RobotRequest& request, const std::string& late);

/// Shows the steps of the stages.
inline Told shown_by(Progress& progress) {
  return [&progress](const std::string& step, double weight) { progress.begin(step, weight); };
}

}  // namespace flashbvh::tool
