#include "cli/commands.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "flashbvh/image.hpp"
#include "flashbvh/version.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

std::string version_text() {
  return concat("flashbvh ", FLASHBVH_VERSION_MAJOR, ".", FLASHBVH_VERSION_MINOR, ".",
                FLASHBVH_VERSION_PATCH);
}

void add_example(CLI::App& command, const std::string& line, const std::string& what) {
  command.footer(concat("Example:\n  flashbvh ", line, "  # ", what));
}

void check_output(const std::string& output, const std::vector<std::string>& inputs) {
  refuse_to_replace_inputs(output, inputs);
  std::uint32_t magic = 0;
  std::error_code error;
  if (!std::filesystem::is_regular_file(output, error)) {
    return;
  }
  std::ifstream file(output, std::ios::binary);
  file.read(reinterpret_cast<char*>(&magic), sizeof magic);
  if (file && magic == kImageMagic) {
    throw UserError(output, "is an image, which would be replaced; write elsewhere");
  }
}

CLI::Option* add_posed_images(CLI::App& command, PosedImages& to) {
  add_option(command, "A", to.a, "FILE.fbvh", "Image (.fbvh) that stays in place")->required();
  add_option(command, "B", to.b, "FILE.fbvh", "Image (.fbvh) that the poses rotate and translate")
      ->required();
  return add_option(
      command, "--poses", to.poses, "FILE",
      "A pose a line, B into A's frame: the rotation row by row, then the translation "
      "in the mesh's unit; 12 numbers");
}

}  // namespace flashbvh::tool
