// A robot's arrays as initialisers: the same text in C++ and in C but for a few names.
#ifndef FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_TEXT_HPP
#define FLASHBVH_TOOLS_ROBOT_BAKED_ROBOT_TEXT_HPP

#include <algorithm>
#include <string>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "image/source_text.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/matrix/unguarded.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// How a language calls things.
struct RobotLanguage {
  const char* base;            ///< of kBase
  const char* joint_types[3];  ///< revolute, continuous, prismatic
  const char* why_unguarded[2];
  const char* zeros;  ///< of an array
  const char* null;
};

extern const RobotLanguage kRobotInCpp;
extern const RobotLanguage kRobotInC;

/// "{...}"
std::string text_of(const Mount& mount, const RobotLanguage& language);
std::string text_of(const RobotJoint& joint, const RobotLanguage& language);
std::string text_of(const RobotLink& link, const RobotLanguage& language);
std::string text_of(const RobotPair& pair, const RobotLanguage& language);
std::string text_of(std::uint32_t reach, const RobotLanguage& language);
std::string text_of(std::uint8_t distance, const RobotLanguage& language);

/// The pairs that no guard looks at, in both languages.
constexpr const char* kUnguardedComment =
    "Pairs of links that a joint moves and no guard looks at: their collisions are never detected.";
/// "{table, bridge, why, 0}"; `links`: the names of the links' numbers.
std::string text_of(const UnguardedPair& pair, const std::vector<std::string>& links,
                    const RobotLanguage& language);

/// "PREFIXconst TYPE NAME[] = {...};", or nothing if there are none: no array is empty.
template <class Element>
std::string array_if_any(const std::string& prefix, const std::string& declaration,
                         const std::vector<Element>& elements, const RobotLanguage& language) {
  return elements.empty() ? ""
                          : prefix + array(declaration + "[]", elements, [&](const Element& e) {
                              return text_of(e, language);
                            }) + "\n";
}

/// The elements of a Robot, by the names of its arrays.
struct RobotArrays {
  const char* joints;
  const char* links;
  const char* meshes;
  const char* pairs;
  const char* reaches;
  const char* distance_tables;
};
std::string text_of(const FixedRobot& robot, const RobotArrays& arrays,
                    const RobotLanguage& language);

std::vector<std::string> names_of_variables(const Model& model);
std::vector<std::string> names_of_links(const Model& model);
std::vector<std::string> names_of_mounts(const Model& model);

/// Of a state's arrays: they have elements.
constexpr std::size_t at_least_one(std::size_t count) {
  return std::max<std::size_t>(count, 1);
}

}  // namespace flashbvh::tool

#endif
