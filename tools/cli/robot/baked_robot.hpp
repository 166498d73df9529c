// A complete robot for commands: baked, its pairs decided, in fixed point. Also the sizes of links,
// and warnings of odd units and coarse cells.
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

/// The robot and its baking options; lengths are texts, as given.
struct RobotArguments {
  std::string urdf;
  std::vector<std::string> packages;
  bool visual_too = false;
  std::string srdf;
  std::vector<std::string> believed;  ///< pairs of the SRDF to believe
  std::optional<std::string> cell;
  std::string stop = "0";
  std::optional<std::string> warn;
  std::vector<std::string> pairs;  ///< pairs with their own distances
  std::vector<std::string> zones;  ///< zones of joints
  std::optional<std::string> time;
  std::uint32_t leaf_size = bake::kDefaultLeafSize;
  bool has_leaf_size = false;           ///< the user chose the leaf size
  std::optional<std::string> simplify;  ///< the largest deviation of firmware's meshes
  std::optional<std::string> fit;       ///< or their largest size in bytes
  bool progress = false;
};

/// Declares the robot's file, its packages and --visual-too.
void add_described_options(CLI::App& command, const std::string& name, RobotArguments& arguments);
/// Declares all options of a robot: all commands share them and describe the same robot.
void add_robot_options(CLI::App& command, const std::string& name, RobotArguments& arguments);
/// Declares --time. `late`: the fate of pairs undecided by then.
void add_time(CLI::App& command, RobotArguments& arguments, const std::string& late);

/// A guard may stop two simplified links earlier by this many deviations: two for the meshes and
/// two for the slack.
constexpr double kEarlyByDeviation = 4;

/// Its members point into each other; moving the object is safe.
struct BakedRobot {
  Model model;
  double cell;  ///< metres
  /// Trees on which pairs are decided: of the links, then of the parts of links that a guard tests.
  std::vector<BakedPart> wholes;
  std::vector<BakedLink> links;  ///< firmware's trees in the same order, once all is decided
  std::vector<Size> sizes;       ///< of links, in their frames, in metres; also of an image
  Reaches reaches;               ///< of the links, then of the parts
  std::vector<std::size_t> links_of_parts;  ///< the link of each part
  MatrixOptions options;   ///< used to decide pairs; includes the deadline for parts
  Deadline deadline = {};  ///< of the whole work
  std::vector<JointZone> zones;
  std::set<std::size_t> late_joints;  ///< without a zone when its time was up
  std::vector<PairVerdict> pairs;
  std::vector<UnguardedPair> unguarded;  ///< also of an image
  double simplified = 0;        ///< allowed deviation of firmware's links in metres; 0: none
  std::uint32_t leaf_size = 0;  ///< of firmware's links
  std::size_t own_bytes = 0;    ///< size of the image without meshes
  std::unique_ptr<FixedRobot> fixed;
  std::unique_ptr<RobotFile> file;  ///< of an image, in place of the baked data

  const Robot& robot() const { return file ? file->robot() : fixed->robot(); }
};

/// The robot as described. UserError for errors in its files or in `arguments`.
Model described_robot(const RobotArguments& arguments, Warnings& warnings);

/// A robot with its pairs decided, but without firmware's data.
BakedRobot decided_robot(Model model, const RobotArguments& arguments, Warnings& warnings);
/// Takes some seconds per pair if proofs are hard. UserError if it cannot be baked.
BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings);

/// The robot's image: the image that was read, or a new one with this name.
std::vector<std::uint32_t> image_of(const BakedRobot& robot, const std::string& name);

/// Sizes in metres, in the links' own frames.
std::vector<Size> link_sizes(const Model& model);
/// Sizes of a model without meshes, from the baked meshes. `cell`: of the meshes.
std::vector<Size> link_sizes(const Model& model, const Mesh* meshes, double cell);

/// Warns of links with odd sizes, and of meshes that are all far larger than the distances of the
/// joints. `path`: the URDF.
void warn_of_sizes(const Model& model, const std::vector<Size>& sizes, const std::string& path,
                   Warnings& warnings);

/// Warns if the cell is coarser than a tenth of the stop distance, or a link has few cells.
/// Names the option that gives the cell, or else the cause of a coarse one. Lengths are in metres.
void warn_of_cell(const Model& model, const std::vector<Size>& sizes, double cell, double stop,
                  const RobotArguments& arguments, Warnings& warnings);

}  // namespace flashbvh::tool
