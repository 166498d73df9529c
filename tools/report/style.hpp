// How a page looks.
#ifndef FLASHBVH_TOOLS_REPORT_STYLE_HPP
#define FLASHBVH_TOOLS_REPORT_STYLE_HPP

#include <string>

namespace flashbvh::report {

/// CSS: light and dark, for any width, and on paper.
std::string page_style();

}  // namespace flashbvh::report

#endif
