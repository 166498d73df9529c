// Reads robots' binary images.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flashbvh/robot/image.hpp"
#include "robot/matrix/unguarded.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// True if a path ends in .robot.
bool is_robot_file_name(const std::string& path);

/// An image in memory, opened and validated by the library.
class RobotFile {
 public:
  /// UserError if the file can't be read or is no valid image of a robot.
  explicit RobotFile(const std::string& path);
  /// Opens the bytes of a file; `path` is its name for messages.
  RobotFile(const std::string& path, const std::string& bytes);
  RobotFile(const RobotFile&) = delete;
  RobotFile& operator=(const RobotFile&) = delete;

  /// A view into the object.
  const Robot& robot() const { return robot_; }
  const RobotImageHeader& header() const { return header_; }
  const std::vector<std::uint32_t>& words() const { return words_; }
  /// header().byte_count bytes.
  const char* bytes() const { return reinterpret_cast<const char*>(words().data()); }
  double cell() const { return cell_of(robot_); }                 ///< in metres
  std::string name() const { return robot_name(words_.data()); }  ///< of the robot
  /// The model without its URDF: names, joints, attached links and mounts, but no meshes.
  Model model() const;
  std::vector<UnguardedPair> unguarded() const;

 private:
  std::string path_;
  std::vector<std::uint32_t> words_;  ///< the bytes, aligned
  RobotImageHeader header_{};
  std::vector<Mesh> meshes_;
  Robot robot_{};
};

}  // namespace flashbvh::tool
