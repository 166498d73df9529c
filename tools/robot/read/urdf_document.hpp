// What a URDF says, as it says it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/kinematics.hpp"

namespace flashbvh::tool {

/// Lengths are in metres, angles in radians; all numbers are finite.
struct UrdfGeometry {
  enum class Shape : std::uint8_t { box, cylinder, sphere, mesh };

  Shape shape = Shape::box;
  Vector3 size{};     ///< of a box; of a mesh its scale
  double radius = 0;  ///< of a cylinder or sphere
  double length = 0;  ///< of a cylinder, along z
  std::string mesh;   ///< where it is, as the file says
};

struct UrdfCollision {
  Transform origin;  ///< in the link's frame
  UrdfGeometry geometry;
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfCollision> collisions;
  bool has_visual = false;
};

struct UrdfMimic {
  std::string joint;
  double multiplier = 1;
  double offset = 0;
};

struct UrdfJoint {
  enum class Type : std::uint8_t { fixed, revolute, continuous, prismatic };

  std::string name;
  Type type = Type::fixed;
  std::size_t parent = 0;  ///< links, by number
  std::size_t child = 0;
  Transform origin;       ///< in the parent's frame
  Vector3 axis{1, 0, 0};  ///< of any length
  double lower = 0;       ///< of a continuous joint, too, if the file gives them
  double upper = 0;
  std::optional<UrdfMimic> mimic;  ///< none on fixed joints
};

/// Links and joints in the order of the file. The joints make a tree.
struct UrdfRobot {
  std::string name;
  std::size_t root = 0;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  /// Of joints with soft limits other than their limits: these count, those do not.
  std::vector<std::string> soft_limits;
};

/// UserError, with the element and the remedy, if the file is no URDF, or has what firmware can't
/// hold: joints that float or slide in a plane, shapes that are none of UrdfGeometry::Shape, loops.
UrdfRobot read_urdf_document(const std::string& path);

}  // namespace flashbvh::tool
