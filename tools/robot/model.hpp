// A robot as its file says, made ready to be baked: a tree of moving joints, bodies that hang on
// them.
//
// Fixed joints are gone: what hangs on one hangs on the moving joint before it. A joint's frame is
// turned so that the axis is its z; meshes are in the frame of the joint they hang on. Lengths are
// in metres, angles in radians.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "flashbvh/robot/robot.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

/// Point p lies at rotation * p + translation.
struct Transform {
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> translation{};
};

/// In place of a joint's number: none, the base.
constexpr std::size_t kNoJoint = static_cast<std::size_t>(-1);

struct ModelJoint {
  std::string name;
  std::size_t parent = kNoJoint;  ///< a joint before this one
  Transform fixed;                ///< in the parent's frame, where its coordinate is 0
  JointType type = JointType::revolute;
  double lower = 0;  ///< limits, both allowed; of a continuous joint -pi and pi
  double upper = 0;
  /// The coordinate is multiplier * (that of the variable) + offset; 1 and 0 but for mimics.
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
  std::vector<std::size_t> source_begins;  ///< of each source, its first triangle in `mesh`
  std::vector<std::string> files;          ///< that were read
  double precision = 0;                    ///< how far readers may have rounded a coordinate
};

/// A link's own frame, which a tool may be fastened in: of every link of the URDF.
struct ModelMount {
  std::string name;
  std::size_t joint = kNoJoint;
  Transform transform;  ///< in the joint's frame
};

/// What the SRDF says of two links: that they need no guard. It is decided all the same.
struct DisabledPair {
  std::size_t a;
  std::size_t b;
  std::string reason;        ///< as the SRDF gives it
  std::size_t line = 0;      ///< of the SRDF
  bool is_believed = false;  ///< the user stands by it, whatever is found
};

struct Model {
  std::string name;
  std::string path;                    ///< its file, for messages
  std::vector<std::string> files;      ///< that were read with it, but for those of the links
  std::vector<ModelJoint> joints;      ///< parents before children
  std::vector<std::size_t> variables;  ///< of each variable, the joint that is no mimic
  std::vector<ModelLink> links;        ///< in the order of the file; behind them parts
  /// So many of the last links are what of another one, of the same name, a guard looks at outside
  /// a joint zone.
  std::size_t part_count = 0;
  std::vector<ModelMount> mounts;
  /// Links next to each other: whose joints, counting links without geometry, are at most one
  /// moving joint apart.
  std::vector<std::pair<std::size_t, std::size_t>> neighbours;
  std::vector<DisabledPair> disabled;

  /// Links that are no parts.
  std::size_t link_count() const { return links.size() - part_count; }
};

/// In place of a link's number: none.
constexpr std::size_t kNoLink = static_cast<std::size_t>(-1);

/// The first link of that name, which is no part, or none.
inline std::size_t find_link(const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].name == name) {
      return i;
    }
  }
  return kNoLink;
}

/// Of the lattice of a robot's meshes, in metres.
inline double cell_of(const Robot& robot) {
  double cell = 0;
  std::memcpy(&cell, &robot.cell_bits, sizeof cell);
  return cell;
}

inline bool is_mimic(const Model& model, std::size_t joint) {
  return model.variables[model.joints[joint].variable] != joint;
}

/// The element of links `a` and `b`, in either order, or null.
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

/// Of a joint that may be none: the base's is `base`.
inline std::string joint_name(const Model& model, std::size_t joint, const char* base) {
  return joint == kNoJoint ? base : model.joints[joint].name;
}

/// "-1 to 1.5 rad, as left by -0.5".
inline std::string moves_of(const Model& model, std::size_t number) {
  const ModelJoint& joint = model.joints[number];
  std::string text = joint.type == JointType::continuous
                         ? "on and on"
                         : significant(joint.lower, 6) + " to " + significant(joint.upper, 6) +
                               (joint.type == JointType::prismatic ? " m" : " rad");
  if (is_mimic(model, number)) {
    text += ", as " + model.joints[model.variables[joint.variable]].name + " by " +
            significant(joint.multiplier, 6);
  }
  return text;
}

}  // namespace flashbvh::tool
