// A robot as text, which the readers of MJCF and SDF pass to this program: one line per fact, its
// parts separated by tabs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/read/urdf_document.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// A reader's result: a robot and its warnings, or the reason why it refuses the file.
struct ReadRobot {
  UrdfRobot robot;
  std::vector<PlacedWarning> warnings;
  std::string refusal;  ///< place and message; empty if there is a robot
};

/// Removes control characters from names.
std::string text_of(const ReadRobot& read);

/// None if the text is incomplete or malformed, or has a wrong number of a link or a vertex. Does
/// not check that the joints make a tree.
std::optional<ReadRobot> robot_of_text(std::string_view text);

}  // namespace flashbvh::tool
