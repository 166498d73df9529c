// What the user requests of a robot, as given and parsed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bake/build_tree.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/matrix.hpp"
#include "robot/read/link_mesh.hpp"
#include "text/deadline.hpp"

namespace flashbvh::tool {

/// A robot's files and how to bake it; lengths are texts, as given.
struct RobotRequest {
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
  Clock::time_point began = Clock::now();  ///< when `time` begins
  bool limits = false;                     ///< firmware calls Guard::limit()
  std::uint32_t leaf_size = bake::kDefaultLeafSize;
  bool has_leaf_size = false;           ///< the user chose the leaf size
  std::optional<std::string> simplify;  ///< the largest deviation of firmware's meshes
  std::optional<std::string> fit;       ///< or their largest size in bytes
};

/// In metres. UserError if a distance or a pair is invalid.
AllDistances all_distances(const Model& model, const RobotRequest& request);
/// Without those of pairs.
AllDistances usual_distances(const RobotRequest& request);

/// The files of the robot, the SRDF and the meshes, sorted: no output may replace them.
std::vector<std::string> files_read(const RobotRequest& request, const Model& model);
/// UserError, at `place`, if the length is more than `most` in 1/256 cell.
void check_length(double length, std::uint32_t most, const std::string& place, double cell);
/// A number above 0.
double seconds(const std::string& text);
std::optional<double> given_cell(const RobotRequest& request);
/// Above 0, in metres. Precondition: the option was given.
double simplify_length(const RobotRequest& request);
Packages packages_of(const std::vector<std::string>& given);
/// LINK,LINK. `place`: the option that names them.
std::pair<std::size_t, std::size_t> links_of(const Model& model, const std::string& place,
                                             const std::string& names);
/// JOINT=LENGTH, for joints between two links that collide. UserError for a radius of more cells
/// than an image holds.
ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given, double cell);

}  // namespace flashbvh::tool
