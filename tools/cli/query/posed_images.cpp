#include "cli/query/posed_images.hpp"
#include "cli/options.hpp"

namespace flashbvh::tool {

CLI::Option* add_posed_images(CLI::App& command, PosedImages& to) {
  command.add_option("A", to.a, "Image (.fbvh) that stays in place")->required();
  command.add_option("B", to.b, "Image (.fbvh) that the poses rotate and translate")->required();
  return add_option(
      command, "--poses", to.poses, "FILE",
      "A pose a line, B into A's frame: the rotation row by row, then the translation "
      "in the mesh's unit; 12 numbers");
}

void add_float_flag(CLI::App& command, PosedImages& to) {
  command.add_flag("--float", to.floats,
                   "Take the poses' numbers as 32-bit floats, as firmware's pose_of() does: the "
                   "same poses to the bit");
}

}  // namespace flashbvh::tool
