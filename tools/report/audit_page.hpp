// The page about an SRDF that `flashbvh audit --report` writes.
#pragma once

#include <string>

#include "robot/audit/audit.hpp"

namespace flashbvh::tool {

/// One self-contained HTML file: valid lines and missing pairs. `srdf`: its path.
std::string audit_page(const Model& model, const std::string& srdf, const Audit& audit);

}  // namespace flashbvh::tool
