// Where an image's bytes go.
#ifndef FLASHBVH_TOOLS_REPORT_BYTE_PARTS_HPP
#define FLASHBVH_TOOLS_REPORT_BYTE_PARTS_HPP

#include <string>

#include "image/image_file.hpp"

namespace flashbvh::report {

/// A bar and a table, as HTML.
std::string bytes_by_part(const tool::ImageFile& image);

}  // namespace flashbvh::report

#endif
