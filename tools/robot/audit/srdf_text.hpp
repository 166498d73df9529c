// SRDFs as text: written from scratch, or corrected pair by pair with all other bytes kept.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/model.hpp"

namespace flashbvh::tool {

/// Two links that a planner need not check.
struct SrdfLine {
  std::size_t a;
  std::size_t b;
  const char* reason;  ///< MoveIt's: Adjacent, Never, Always, Default, User
};

/// An SRDF with only these lines.
std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines);

/// Pairs (a, b), a below b.
struct SrdfChanges {
  std::vector<std::pair<std::size_t, std::size_t>> enabled;  ///< no longer disabled
  std::vector<SrdfLine> disabled;                            ///< in addition
};

/// The text of the SRDF at `path` with `changes`. Enabling a pair under a
/// <disable_default_collisions> adds an <enable_collisions>. Throws UserError like read_xml().
std::string changed_srdf(const std::string& path, const Model& model, const SrdfChanges& changes);

}  // namespace flashbvh::tool
