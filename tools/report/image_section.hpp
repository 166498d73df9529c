// The part of a page about one image.
#ifndef FLASHBVH_TOOLS_REPORT_IMAGE_SECTION_HPP
#define FLASHBVH_TOOLS_REPORT_IMAGE_SECTION_HPP

#include <string>
#include <vector>

#include "report/subject.hpp"

namespace flashbvh::report {

/// Key figures, pictures, bytes, shape, rounding and warnings.
std::string image_section(const Subject& subject);

/// A row for each image.
std::string summary(const std::vector<const Subject*>& subjects);

}  // namespace flashbvh::report

#endif
