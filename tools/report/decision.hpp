// Lines at the top of a page that say what it comes to.
#ifndef FLASHBVH_TOOLS_REPORT_DECISION_HPP
#define FLASHBVH_TOOLS_REPORT_DECISION_HPP

#include <string>
#include <vector>

#include "robot/unguarded.hpp"

namespace flashbvh::tool {

/// A line: a square in the colour of a style class, what it comes to, and of what; all HTML.
std::string decision(const std::string& style, const std::string& what, const std::string& of);

/// A line a reason: "Not guarded: base - arm (neighbours that ...)". Nothing if there are none.
std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded);

/// The first section of a page.
std::string decision_section(const std::string& title, const std::string& decisions);

/// What their colours need: of each verdict.
std::string decision_style();

}  // namespace flashbvh::tool

#endif
