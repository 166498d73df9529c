// A test's own folder with the files of a robot.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "robot/read/urdf.hpp"

namespace flashbvh::test {

/// The message with which `act()` is refused; empty if it is not refused.
template <class Act>
std::string refusal_of(const Act& act) {
  try {
    (void)act();
    return {};
  } catch (const tool::UserError& error) {
    return error.what();
  }
}

class RobotFiles {
 public:
  RobotFiles() : folder_(std::filesystem::temp_directory_path() / std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  RobotFiles(const RobotFiles&) = delete;
  RobotFiles& operator=(const RobotFiles&) = delete;
  ~RobotFiles() { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// Reads a robot whose <robot> element holds `inside`.
  tool::Model read(const std::string& inside, const std::string& srdf = "") {
    write("arm.urdf", "<robot name=\"arm\">\n" + inside + "</robot>\n");
    return tool::read_urdf(path("arm.urdf"), packages, srdf, warnings);
  }

  /// The message that refuses a robot, without the folder's path; empty if the robot is read.
  std::string refusal(const std::string& inside) {
    std::string text = refusal_of([&] { return read(inside); });
    for (std::size_t at; (at = text.find(folder_.string() + "/")) != std::string::npos;) {
      text.erase(at, folder_.string().size() + 1);
    }
    return text;
  }

  tool::Packages packages;
  tool::Warnings warnings;

 private:
  std::filesystem::path folder_;
};

inline const std::string kBall =
    "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>";

inline std::string link_text(const std::string& name, const std::string& inside = kBall) {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

/// Links of one letter each, with balls.
inline std::string link_texts(const std::string& names) {
  std::string text;
  for (const char name : names) {
    text += link_text(std::string(1, name));
  }
  return text;
}

inline std::string joint_text(const std::string& name, const std::string& type,
                              const std::string& parent, const std::string& child,
                              const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inside + "</joint>\n";
}

/// A chain of links a, b, c and so on; joints j0, j1 and so on lie between. `joints`: their types
/// and elements.
inline std::string chain_text(const std::vector<std::pair<std::string, std::string>>& joints) {
  std::string text = link_text("a");
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::string parent(1, static_cast<char>('a' + i));
    const std::string child(1, static_cast<char>('b' + i));
    text += link_text(child) +
            joint_text("j" + std::to_string(i), joints[i].first, parent, child, joints[i].second);
  }
  return text;
}

inline const std::string kLimit = "<limit lower=\"-1\" upper=\"2\" effort=\"1\" velocity=\"1\"/>";

}  // namespace flashbvh::test
