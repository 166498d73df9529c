// The part of a page that shows a mesh with the boxes of its tree.
#ifndef FLASHBVH_TOOLS_REPORT_PICTURES_HPP
#define FLASHBVH_TOOLS_REPORT_PICTURES_HPP

#include <string>

#include "report/subject.hpp"

namespace flashbvh::report {

/// Four views and a choice of levels, which works by style alone.
std::string pictures(const Subject& subject);

/// What the style needs for the choice.
std::string picture_style();

}  // namespace flashbvh::report

#endif
