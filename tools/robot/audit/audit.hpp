// Checks the lines of an SRDF against the decided matrix, and writes an SRDF of the lines that
// hold.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/pipeline/decide.hpp"

namespace flashbvh::tool {

/// Two links that a planner need not check.
struct SrdfLine {
  std::size_t a;
  std::size_t b;
  const char* reason;    ///< MoveIt's: Adjacent, Never, Always, Default, User
  std::string why = {};  ///< an explanation for users
};

enum class LineVerdict : std::uint8_t {
  proven,  ///< the two links never collide
  /// They intersect at all configurations tried, or in their joint's zone: a planner must not check
  /// them.
  contact,
  /// They intersect at the default configuration, as "Default" promises; apart at others.
  at_default,
  believed,   ///< they may collide, and the user vouches for the line
  refuted,    ///< they can collide, with a witness
  undecided,  ///< neither proven nor refuted
};
constexpr LineVerdict kLineVerdicts[] = {LineVerdict::proven,     LineVerdict::contact,
                                         LineVerdict::at_default, LineVerdict::believed,
                                         LineVerdict::refuted,    LineVerdict::undecided};
const char* name_of(LineVerdict verdict);

/// A triangle of a file or of a primitive, counted from 0.
struct FileTriangle {
  std::string source;
  std::size_t triangle;
};

struct AuditedLine {
  DisabledPair line;
  PairVerdict pair;  ///< its witness is where links in contact touch, too
  LineVerdict verdict;
  std::string why;  ///< an explanation for users
  /// For `refuted`: the triangles that intersect at the witness.
  std::array<FileTriangle, 2> triangles;
};

struct Audit {
  std::vector<AuditedLine> lines;  ///< in the SRDF's order
  std::vector<SrdfLine> valid;     ///< all pairs that a planner need not check, or believed
  std::vector<SrdfLine> missing;   ///< those of them that the SRDF leaves enabled

  std::size_t count(LineVerdict verdict) const;
};

/// `disabled`: the SRDF's pairs, from read_srdf(); the model has none.
Audit audit_of(const Prepared& robot, const Decided& decided,
               const std::vector<DisabledPair>& disabled);

/// The text of an SRDF with only these lines.
std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines);

}  // namespace flashbvh::tool
