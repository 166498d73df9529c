// A page about an SRDF: what `flashbvh audit --report` writes.
#pragma once

#include <string>

#include "robot/audit/audit.hpp"

namespace flashbvh::tool {

/// One self-contained HTML file: which lines hold, which pairs are missing. `srdf`: its path.
std::string audit_page(const Model& model, const std::string& srdf, const Audit& audit);

}  // namespace flashbvh::tool
