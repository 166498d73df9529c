// What is in a mesh's image, as `info` and pages show it.
#pragma once

#include "cli/table.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Names and values, in the order of all outputs.
Json image_facts(const ImageFile& image);

}  // namespace flashbvh::tool
