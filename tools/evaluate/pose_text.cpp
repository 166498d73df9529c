#include "evaluate/pose_text.hpp"

#include "text/files.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"
#include "text/user_error.hpp"

namespace flashbvh::tool {

RigidPose parse_pose(std::string_view text, const std::string& place) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != 12) {
    throw UserError(place, "has " + std::to_string(words.size()) +
                               " numbers; a pose has 12: the rotation row by row, then the "
                               "translation");
  }
  std::array<double, 12> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) {
      throw UserError(place, "'" + std::string(words[i].substr(0, 40)) +
                                 "' is no finite number; a pose has 12 of them");
    }
    numbers[i] = *number;
  }
  RigidPose pose{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      pose.rotation[row][column] = numbers[3 * row + column];
    }
    pose.translation[row] = numbers[9 + row];
  }
  return pose;
}

std::vector<PlacedPose> read_poses(const std::string& path) {
  const std::string text = read_file(path);
  std::vector<PlacedPose> poses;
  for (Lines lines(text); lines.next_content();) {
    const std::string place = path + ":" + std::to_string(lines.number());
    poses.push_back({parse_pose(lines.line(), place), place});
  }
  if (poses.empty()) {
    throw UserError(path, "has no poses; write 12 numbers a line");
  }
  return poses;
}

}  // namespace flashbvh::tool
