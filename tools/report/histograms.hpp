// How deep, how full and how branched a tree is, as tables with bars.
#ifndef FLASHBVH_TOOLS_REPORT_HISTOGRAMS_HPP
#define FLASHBVH_TOOLS_REPORT_HISTOGRAMS_HPP

#include <string>

#include "report/tree_shape.hpp"

namespace flashbvh::report {

std::string histograms(const TreeShape& shape);

}  // namespace flashbvh::report

#endif
