// What the file of a robot says, as it says it: a URDF, or another form as if it were one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "robot/kinematics.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// Lengths are in metres, angles in radians; all numbers are finite.
struct UrdfGeometry {
  enum class Shape : std::uint8_t { box, cylinder, sphere, capsule, ellipsoid, mesh, triangles };

  Shape shape = Shape::box;
  Vector3 size{};        ///< of a box or an ellipsoid, from side to side; of a mesh its scale
  double radius = 0;     ///< of a cylinder, sphere or capsule
  double length = 0;     ///< along z, of a cylinder; of a capsule without its round ends
  std::string mesh{};    ///< where it is, as the file says; of triangles a name
  double precision = 0;  ///< how far the reader may have moved a vertex of `triangles`
  bake::SourceMesh triangles{};
};

struct UrdfCollision {
  Transform origin;  ///< in the link's frame
  UrdfGeometry geometry;
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfCollision> collisions;
  bool has_visual = false;
  std::vector<UrdfCollision> visuals;  ///< of forms other than URDF
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
  Vector3 anchor{};       ///< a point of the axis, in the child's frame
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
  std::vector<std::string> files;  ///< that were read with the robot's own
  bool is_mjcf = false;            ///< for messages: it has geoms, no <visual> and no <collision>
};

/// The URDF `text` of the file `path`. UserError, with the element and the remedy, if it is none,
/// or has what firmware can't hold: joints that slide in a plane, or float and hold no base, shapes
/// that URDF has not, loops. Soft limits narrow limits. `visual_too`: a link without <collision>
/// collides by its <visual>.
UrdfRobot read_urdf_document(const std::string& path, std::string text, bool visual_too,
                             Warnings& warnings);

/// UserError if the name of a file ends as that of a mesh or of a model of CAD.
void check_no_mesh(const std::string& path);

/// UserError if a link hangs on two joints, or on a loop.
void check_tree(const std::vector<UrdfLink>& links, const std::vector<UrdfJoint>& joints,
                const std::string& path);

}  // namespace flashbvh::tool
