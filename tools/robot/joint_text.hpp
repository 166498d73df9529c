// Joints in words.
#ifndef FLASHBVH_TOOLS_ROBOT_JOINT_TEXT_HPP
#define FLASHBVH_TOOLS_ROBOT_JOINT_TEXT_HPP

#include <string>

#include "robot/model.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

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

#endif
