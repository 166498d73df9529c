// Makes a URDF ready for urdfdom: takes out what is nothing to us, and finds faults that it would
// skip.
#pragma once

#include <string>
#include <vector>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Of a <safety_controller>: what the machine keeps to.
struct SoftLimits {
  std::optional<double> lower;
  std::optional<double> upper;
};

/// What the file says, without what is nothing to us.
struct TrimmedRobot {
  std::string text;
  std::vector<UrdfLink> links;          ///< without their collisions
  std::vector<UrdfJoint> joints;        ///< which links they join, no more
  std::vector<SoftLimits> soft_limits;  ///< of each joint
};

/// Of the URDF `text` of the file `path`. UserError as of read_urdf_document().
TrimmedRobot trimmed_urdf(const std::string& path, std::string text, bool visual_too,
                          Warnings& warnings);

}  // namespace flashbvh::tool
