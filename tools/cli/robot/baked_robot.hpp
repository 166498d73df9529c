// A robot for commands that need all of it: baked, its pairs decided, in fixed point.
#ifndef FLASHBVH_TOOLS_CLI_BAKED_ROBOT_HPP
#define FLASHBVH_TOOLS_CLI_BAKED_ROBOT_HPP

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/mesh/mesh_warnings.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/baked/robot_file.hpp"
#include "robot/matrix/matrix.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Which robot, and how it is baked; lengths as they are given.
struct RobotArguments {
  std::string urdf;
  std::vector<std::string> packages;
  std::string srdf;
  std::vector<std::string> believed;  ///< pairs that the SRDF disables
  std::optional<std::string> cell;
  std::string stop = "0";
  std::optional<std::string> warn;
  std::vector<std::string> pairs;  ///< with distances of their own
  std::uint32_t leaf_size = bake::kDefaultLeafSize;
  bool progress = false;
};

/// Declares them: the same for all commands, so that they speak of the same robot.
void add_robot_options(CLI::App& command, const std::string& name, RobotArguments& arguments);

/// Its parts point into each other; it may be moved.
struct BakedRobot {
  Model model;
  double cell;  ///< metres
  std::vector<BakedLink> links;
  std::vector<Size> sizes;  ///< of the links, in their own frames, in metres; of an image, too
  std::vector<PairVerdict> pairs;
  std::vector<UnguardedPair> unguarded;  ///< of an image, too
  std::unique_ptr<FixedRobot> fixed;
  std::unique_ptr<RobotFile> file;  ///< instead of all three, of an image

  const Robot& robot() const { return file ? file->robot() : fixed->robot(); }
};

/// As it is described. UserError for it, and for what `arguments` say that is none.
Model described_robot(const RobotArguments& arguments, Warnings& warnings);
/// The URDF, the SRDF and the meshes, or the image: what no output may replace.
std::set<std::string> files_read(const RobotArguments& arguments, const Model& model);

/// Takes some seconds a pair where proofs are hard. UserError for all that can't be baked.
BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings);

/// Of an image, as it was baked. UserError if it is none, or if `command` was given options of
/// add_robot_options(): they are for baking.
BakedRobot opened_robot(const std::string& path, const CLI::App& command, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
