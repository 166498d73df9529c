// Prepares a URDF for urdfdom: leaves out unused elements, and finds faults that urdfdom would
// skip.
#pragma once

#include <string>
#include <vector>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// The limits of a <safety_controller>.
struct SoftLimits {
  std::optional<double> lower;
  std::optional<double> upper;
};

/// The contents of a file without unused elements.
struct TrimmedRobot {
  std::string text;
  std::vector<UrdfLink> links;          ///< without their collisions
  std::vector<UrdfJoint> joints;        ///< with names and links only
  std::vector<SoftLimits> soft_limits;  ///< of each joint
};

/// Reads a URDF. UserError like read_urdf_document().
TrimmedRobot trimmed_urdf(const std::string& path, bool visual_too, Warnings& warnings);

}  // namespace flashbvh::tool
