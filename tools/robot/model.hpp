// A robot read from its file and prepared for baking: a tree of moving joints, with links attached.
//
// Fixed joints are removed: their links are attached to the nearest moving joint towards the base.
// A joint's frame is rotated so that its axis is z; meshes are in the frame of their link's joint.
// Lengths are in metres, angles in radians.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "evaluate/poses.hpp"
#include "flashbvh/robot/robot.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

/// The joint number of the base.
constexpr std::size_t kNoJoint = static_cast<std::size_t>(-1);

struct ModelJoint {
  std::string name;
  std::size_t parent = kNoJoint;  ///< a joint before this one
  Transform fixed;                ///< frame in the parent's frame at coordinate 0
  JointType type = JointType::revolute;
  double lower = 0;  ///< limits, both inclusive; -pi and pi for a continuous joint
  double upper = 0;
  /// coordinate = multiplier * variable + offset; 1 and 0 unless the joint is a mimic.
  std::size_t variable = 0;
  double multiplier = 1;
  double offset = 0;
};

/// A link with collision geometry.
struct ModelLink {
  std::string name;
  std::size_t joint = kNoJoint;
  bake::SourceMesh mesh;                   ///< all its collision elements, in the joint's frame
  std::vector<std::string> sources;        ///< files and primitives, for messages
  std::vector<std::size_t> source_begins;  ///< each source's first triangle in `mesh`
  std::vector<std::string> files;          ///< all files that were read
  double precision = 0;                    ///< bound on a reader's rounding of a coordinate
};

/// A link's own frame, to which a tool can be attached; every link of the URDF has one.
struct ModelMount {
  std::string name;
  std::size_t joint = kNoJoint;
  Transform transform;  ///< in the joint's frame
};

/// Two links that the SRDF exempts from checks. They are decided nevertheless.
struct DisabledPair {
  std::size_t a;
  std::size_t b;
  std::string reason;        ///< as given in the SRDF
  std::size_t line = 0;      ///< in the SRDF
  bool is_believed = false;  ///< the user vouches for the line, regardless of the verdict
};

struct Model {
  std::string name;
  std::string path;                    ///< path of its file, for messages
  std::vector<ModelJoint> joints;      ///< parents before children
  std::vector<std::size_t> variables;  ///< for each variable, its joint that is no mimic
  /// In the order of the file, followed by parts. Parts are added after all pairs are decided.
  std::vector<ModelLink> links;
  /// The number of parts at the end of `links`. A part is the portion of the link with its name
  /// that a guard checks outside a joint zone.
  std::size_t part_count = 0;
  std::vector<ModelMount> mounts;
  /// Neighbours: links attached to one joint, or to a joint and its parent.
  std::vector<std::pair<std::size_t, std::size_t>> neighbours;
  /// Links that one joint of the file joins: parent and child. For SRDFs.
  std::vector<std::pair<std::size_t, std::size_t>> adjacent;
  std::vector<DisabledPair> disabled;

  /// The number of links that are not parts.
  std::size_t link_count() const { return links.size() - part_count; }
};

/// The number of no link.
constexpr std::size_t kNoLink = static_cast<std::size_t>(-1);

/// The first link of that name, which is never a part, or kNoLink.
inline std::size_t find_link(const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].name == name) {
      return i;
    }
  }
  return kNoLink;
}

/// Firmware's number of a joint, and back.
inline std::uint8_t fixed_joint(std::size_t joint) {
  return joint == kNoJoint ? kBase : static_cast<std::uint8_t>(joint);
}
inline std::size_t joint_of(std::uint8_t fixed) {
  return fixed == kBase ? kNoJoint : fixed;
}

/// The lattice cell of a robot's meshes, in metres.
inline double cell_of(const Robot& robot) {
  double cell = 0;
  std::memcpy(&cell, &robot.cell_bits, sizeof cell);
  return cell;
}

inline bool is_mimic(const Model& model, std::size_t joint) {
  return model.variables[model.joints[joint].variable] != joint;
}

/// The element for links `a` and `b`, in either order, or null.
template <class Elements>
auto find_pair(Elements& elements, std::size_t a, std::size_t b) {
  const auto found = std::find_if(elements.begin(), elements.end(), [&](const auto& of) {
    return std::minmax(of.a, of.b) == std::minmax(a, b);
  });
  return found == elements.end() ? nullptr : &*found;
}

inline const char* type_name(JointType type) {
  return type == JointType::prismatic    ? "prismatic"
         : type == JointType::continuous ? "continuous"
                                         : "revolute";
}

/// A joint's name, or `base` for kNoJoint.
inline std::string joint_name(const Model& model, std::size_t joint, const char* base) {
  return joint == kNoJoint ? base : model.joints[joint].name;
}

}  // namespace flashbvh::tool
