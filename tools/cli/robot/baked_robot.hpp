// A robot for commands that need all of it: baked, its pairs decided, in fixed point; how large its
// links are, and what looks like another unit, or is too coarse.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/mesh/mesh_warnings.hpp"
#include "flashbvh/mesh.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/baked/robot_file.hpp"
#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/matrix.hpp"
#include "robot/matrix/unguarded.hpp"
#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Which robot, and how it is baked; lengths as they are given.
struct RobotArguments {
  std::string urdf;
  std::vector<std::string> packages;
  std::string joint_limits;
  bool visual_too = false;
  std::string srdf;
  std::vector<std::string> believed;  ///< pairs that the SRDF disables
  std::optional<std::string> cell;
  std::string stop = "0";
  std::optional<std::string> warn;
  std::vector<std::string> pairs;  ///< with distances of their own
  std::vector<std::string> zones;  ///< of joints
  std::optional<std::string> time;
  std::uint32_t leaf_size = bake::kDefaultLeafSize;
  bool has_leaf_size = false;           ///< the user chose it
  std::optional<std::string> simplify;  ///< how far what firmware gets may deviate
  std::optional<std::string> fit;       ///< or what it may take
  bool progress = false;
};

/// Declares the robot's file, its packages, its joint limits and --visual-too.
void add_described_options(CLI::App& command, const std::string& name, RobotArguments& arguments);
/// Declares them all: the same for all commands, so that they speak of the same robot.
void add_robot_options(CLI::App& command, const std::string& name, RobotArguments& arguments);
/// Declares --time. `late`: what happens to what is not decided by then.
void add_time(CLI::App& command, RobotArguments& arguments, const std::string& late);

/// So many deviations of simplified links earlier a guard may stop two of them: both by the meshes,
/// both by the slack.
constexpr double kEarlyByDeviation = 4;

/// Its parts point into each other; it may be moved.
struct BakedRobot {
  Model model;
  double cell;  ///< metres
  /// Trees on which pairs are decided: of the links, then of the parts of links that a guard tests.
  std::vector<BakedPart> wholes;
  std::vector<BakedLink> links;  ///< firmware's trees in the same order, once all is decided
  std::vector<Size> sizes;       ///< of the links, in their own frames, in metres; of an image, too
  Reaches reaches;               ///< of the links, and of the parts
  std::vector<std::size_t> links_of_parts;  ///< of each part: its link
  MatrixOptions options;   ///< with which its pairs were decided; until when parts are sought
  Deadline deadline = {};  ///< of all
  std::vector<JointZone> zones;
  std::vector<std::size_t> late_joints;  ///< with no zone when the time to find one was up
  std::vector<PairVerdict> pairs;
  std::vector<UnguardedPair> unguarded;  ///< of an image, too
  double simplified = 0;        ///< in metres, how far firmware's links were allowed to; 0: not
  std::uint32_t leaf_size = 0;  ///< of firmware's links
  std::size_t own_bytes = 0;    ///< of the image, without meshes
  std::unique_ptr<FixedRobot> fixed;
  std::unique_ptr<RobotFile> file;  ///< instead of all three, of an image

  const Robot& robot() const { return file ? file->robot() : fixed->robot(); }
};

/// As it is described. UserError for it, and for what `arguments` say that is none.
Model described_robot(const RobotArguments& arguments, Warnings& warnings);
/// The robot's files, the SRDF and the meshes, or the image: what no output may replace.
std::set<std::string> files_read(const RobotArguments& arguments, const Model& model);

/// Without what firmware holds: its pairs decided.
BakedRobot decided_robot(Model model, const RobotArguments& arguments, Warnings& warnings);
/// Takes some seconds a pair where proofs are hard. UserError for all that can't be baked.
BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings);

/// Its image: that which was read, or a new one of this name.
std::vector<std::uint32_t> image_of(const BakedRobot& robot, const std::string& name);

/// Of an image, as it was baked. UserError if it is none, or if `command` was given options of
/// add_robot_options(): they are for baking.
BakedRobot opened_robot(const std::string& path, const CLI::App& command, Warnings& warnings);

/// In metres, in the links' own frames.
std::vector<Size> link_sizes(const Model& model);
/// Of a model without meshes, by the baked ones. `cell`: theirs.
std::vector<Size> link_sizes(const Model& model, const Mesh* meshes, double cell);

/// Of links whose size is odd among the others, and of meshes that are all far larger than where
/// the joints lie. `path`: the URDF.
void warn_of_sizes(const Model& model, const std::vector<Size>& sizes, const std::string& path,
                   Warnings& warnings);

/// If the cell is coarser than a tenth of the stop distance, or a link has few cells. `place`: what
/// the cell follows from. Lengths are in metres.
void warn_of_cell(const Model& model, const std::vector<Size>& sizes, double cell, double stop,
                  const std::string& place, Warnings& warnings);

}  // namespace flashbvh::tool
