// Checks the lines of an SRDF against the decided matrix, and writes an SRDF of the lines that
// hold.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "robot/matrix/matrix.hpp"

namespace flashbvh::tool {

/// Two links that a planner need not check.
struct SrdfLine {
  std::size_t a;
  std::size_t b;
  const char* reason;  ///< MoveIt's: Adjacent, Never, Always, Default, User
};

enum class LineVerdict : std::uint8_t {
  proven,  ///< the two links never collide
  /// They intersect at all configurations tried, or in their joint's zone: a planner must not check
  /// them.
  contact,
  refuted,    ///< they can collide, with a witness
  undecided,  ///< neither proven nor refuted
};
const char* name_of(LineVerdict verdict);

/// A triangle of a file or of a primitive, counted from 0.
struct FileTriangle {
  std::string source;
  std::size_t triangle;
};

struct AuditedLine {
  DisabledPair line;
  PairVerdict pair;
  LineVerdict verdict;
  std::string why;  ///< an explanation for users
  /// For `refuted`: the triangles that intersect at the witness.
  std::array<FileTriangle, 2> triangles;
};

struct MissingLine {
  SrdfLine line;
  std::string why;
};

struct Audit {
  std::vector<AuditedLine> lines;    ///< in the SRDF's order
  std::vector<MissingLine> missing;  ///< pairs that the SRDF leaves enabled needlessly

  std::size_t count(LineVerdict verdict) const;
};

/// A robot whose pairs are decided, none of them believed.
struct DecidedPairs {
  const Model& model;
  const std::vector<WholeMesh>& meshes;
  double cell;  ///< metres
  const std::vector<PairVerdict>& pairs;
  /// Joints whose zone search ran out of time: a collision of the links next to such a joint may
  /// lie in the zone and refutes nothing.
  std::set<std::size_t> late_joints = {};
};

/// Lines for all pairs that a planner need not check.
std::vector<SrdfLine> srdf_lines(const DecidedPairs& decided);

/// The text of an SRDF with only these lines.
std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines);

/// `disabled`: the SRDF's pairs, from read_srdf().
Audit audit_of(const DecidedPairs& decided, const std::vector<DisabledPair>& disabled);

/// "64 lines: 60 proven, 3 contact, 1 refuted, 0 undecided; 2 pairs are missing".
std::string summary_of(const Audit& audit);

}  // namespace flashbvh::tool
