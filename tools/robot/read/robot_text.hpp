// A robot as text: what the programs that read MJCF and SDF pass to this one. A line a fact, its
// parts separated by tabs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// What a reader found: a robot and its warnings, or why it refuses the file.
struct ReadRobot {
  UrdfRobot robot;
  std::vector<PlacedWarning> warnings;
  std::string refusal;  ///< place and message; empty if there is a robot
};

/// Names lose control characters.
std::string text_of(const ReadRobot& read);

/// Nothing if the text is not such a one to its end: a number, or that of a link or a vertex, is
/// wrong. Whether the joints make a tree is not looked at.
std::optional<ReadRobot> robot_of_text(std::string_view text);

}  // namespace flashbvh::tool
