// Options of a robot that commands share, and their meaning.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/robot/baked_robot.hpp"
#include "robot/read/link_mesh.hpp"

namespace flashbvh::tool {

/// In metres.
struct Distances {
  double stop;
  double warn;
};

/// All that are guarded alike, and pairs with their own.
struct AllDistances {
  Distances usual;
  std::vector<GuardedPair> own;
};

/// UserError for all that they say that is none.
AllDistances all_distances(const Model& model, const RobotArguments& arguments);
Distances usual_distances(const RobotArguments& arguments);
/// Of two links, their own heeded.
Distances distances_of(const AllDistances& distances, const PairVerdict& pair);
/// The least one above 0; 0 if there is none.
double least_stop(const AllDistances& distances);

/// Above 0.
double seconds(const std::string& text);
std::optional<double> given_cell(const RobotArguments& arguments);
/// Above 0, in metres. Precondition: it is given.
double simplify_length(const RobotArguments& arguments);
std::size_t fit_bytes(const RobotArguments& arguments);
Packages packages_of(const std::vector<std::string>& given);
/// LINK,LINK. `place`: the option that names them.
std::pair<std::size_t, std::size_t> links_of(const Model& model, const std::string& place,
                                             const std::string& names);
/// JOINT=LENGTH, each of a joint between two links that collide.
ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given);

}  // namespace flashbvh::tool
