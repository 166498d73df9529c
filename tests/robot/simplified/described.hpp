// A robot given on a program's command line, in the syntax of `flashbvh robot`.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "robot/read/urdf.hpp"

namespace flashbvh::test {

struct Described {
  std::string urdf;
  std::vector<std::string> packages;  ///< NAME=FOLDER
  bool visual_too = false;

  void add_to(CLI::App& app) {
    app.add_option("URDF", urdf)->required();
    app.add_option("--package", packages);
    app.add_flag("--visual-too", visual_too);
  }

  /// Throws UserError if it is no robot.
  tool::Model read() const {
    tool::Packages folders;
    for (const std::string& package : packages) {
      const std::size_t equals = std::min(package.find('='), package.size() - 1);
      folders[package.substr(0, equals)] = package.substr(equals + 1);
    }
    tool::Warnings warnings;
    return read_urdf(urdf, folders, "", warnings, "", visual_too);
  }
};

}  // namespace flashbvh::test
