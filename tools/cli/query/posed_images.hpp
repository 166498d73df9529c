// Arguments of commands that query two images in poses.
#ifndef FLASHBVH_TOOLS_CLI_POSED_IMAGES_HPP
#define FLASHBVH_TOOLS_CLI_POSED_IMAGES_HPP

#include <CLI/CLI.hpp>
#include <string>

namespace flashbvh::tool {

struct PosedImages {
  std::string a;
  std::string b;
  std::string poses;
  bool floats = false;
};

/// Declares A, B and --poses, which it returns.
CLI::Option* add_posed_images(CLI::App& command, PosedImages& to);

/// Declares --float.
void add_float_flag(CLI::App& command, PosedImages& to);

}  // namespace flashbvh::tool

#endif
