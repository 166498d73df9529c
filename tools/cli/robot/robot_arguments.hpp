// Options of a robot that commands share, parsed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/robot/baked_robot.hpp"
#include "robot/read/link_mesh.hpp"

namespace flashbvh::tool {

/// Distances in metres.
struct Distances {
  double stop;
  double warn;
};

/// The distances of most pairs, and pairs with their own distances.
struct AllDistances {
  Distances usual;
  std::vector<GuardedPair> own;
};

/// UserError if a distance or a pair is invalid.
AllDistances all_distances(const Model& model, const RobotArguments& arguments);
Distances usual_distances(const RobotArguments& arguments);
/// The distances of two links: their own, if given.
Distances distances_of(const AllDistances& distances, const PairVerdict& pair);
/// The smallest stop distance above 0; 0 if there is none.
double least_stop(const AllDistances& distances);

/// The files of the robot, the SRDF and the meshes, or the image, sorted: no output may replace
/// them.
std::vector<std::string> files_read(const RobotArguments& arguments, const Model& model);
/// A number above 0.
double seconds(const std::string& text);
std::optional<double> given_cell(const RobotArguments& arguments);
/// Above 0, in metres. Precondition: the option was given.
double simplify_length(const RobotArguments& arguments);
Packages packages_of(const std::vector<std::string>& given);
/// LINK,LINK. `place`: the option that names them.
std::pair<std::size_t, std::size_t> links_of(const Model& model, const std::string& place,
                                             const std::string& names);
/// JOINT=LENGTH, for joints between two links that collide. UserError for a radius of more cells
/// than an image holds.
ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given, double cell);

}  // namespace flashbvh::tool
