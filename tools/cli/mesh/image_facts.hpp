// What is in a mesh's image, as `info` and pages show it.
#pragma once

#include <string>

#include "cli/table.hpp"
#include "flashbvh/robot/robot.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Names and values, in the order of all outputs.
Json image_facts(const ImageFile& image);

/// UserError unless what the library does not prove of an image holds (lib/docs/format.md).
void check_whole(const ImageFile& image);
void check_whole(const Robot& robot, const std::string& path);

}  // namespace flashbvh::tool
