// The contents of a URDF.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/kinematics.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Lengths are in metres, angles in radians; all numbers are finite.
struct UrdfGeometry {
  enum class Shape : std::uint8_t { box, cylinder, sphere, mesh };

  Shape shape = Shape::box;
  Vector3 size{};      ///< a box's, from side to side; a mesh's scale
  double radius = 0;   ///< of a cylinder or sphere
  double length = 0;   ///< of a cylinder, along z
  std::string mesh{};  ///< path as in the file
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
  Vector3 axis{1, 0, 0};  ///< of any length, in the child's frame
  double lower = 0;       ///< also for a continuous joint, if the file has limits
  double upper = 0;
  std::optional<double> soft_lower = {};  ///< of its <safety_controller>
  std::optional<double> soft_upper = {};
  std::optional<UrdfMimic> mimic;  ///< none on fixed joints
};

/// Links and joints in the order of the file. The joints make a tree.
struct UrdfRobot {
  std::string name;
  std::size_t root = 0;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
};

/// Reads a URDF. UserError, with the element and the remedy, if it is none or exceeds firmware.
/// Firmware has no planar joints, floating joints that hold no base, shapes that are not in URDF,
/// or loops. Soft limits narrow limits. `visual_too`: a link without <collision> collides by its
/// <visual>.
UrdfRobot read_urdf_document(const std::string& path, bool visual_too, Warnings& warnings);

/// UserError if a file's name ends like that of a mesh or of a CAD model.
void check_no_mesh(const std::string& path);

/// For read_urdf_document(): the text for urdfdom, without unused elements. Sets links without
/// their collisions, and joints' names, links and soft limits. UserError also for faults that
/// urdfdom would skip.
std::string trimmed_urdf(const std::string& path, bool visual_too, UrdfRobot& robot,
                         Warnings& warnings);

}  // namespace flashbvh::tool
