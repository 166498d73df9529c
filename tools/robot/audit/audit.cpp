#include "robot/audit/audit.hpp"

#include <algorithm>

#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/unguarded.hpp"
#include "robot/matrix/witness_triangles.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// MoveIt's default: 0, or the middle of the limits if they exclude 0.
double default_value(const ModelJoint& joint) {
  return joint.lower <= 0 && joint.upper >= 0 ? 0 : 0.5 * (joint.lower + joint.upper);
}

PairSpace space_of(const DecidedPairs& decided, const PairVerdict& pair) {
  return {decided.model,
          {pair.a, decided.meshes[pair.a]},
          {pair.b, decided.meshes[pair.b]},
          decided.cell};
}

/// True if the links intersect at the default configuration.
bool intersect_at_default(const DecidedPairs& decided, const PairSpace& space) {
  std::vector<double> at_default;
  for (const Dimension& dimension : space.dimensions()) {
    at_default.push_back(
        default_value(decided.model.joints[decided.model.variables[dimension.variable]]));
  }
  return space.intersect(at_default);
}

/// True if the links intersect at the default configuration and at every other one that is tried.
bool is_in_contact(const DecidedPairs& decided, const PairVerdict& pair) {
  const PairSpace space = space_of(decided, pair);
  return intersect_at_default(decided, space) &&
         intersect_wherever_tried(space, MatrixOptions{}.looks);
}

/// The joint between two neighbours if the search for its zone ran out of time.
std::optional<std::size_t> late_joint(const DecidedPairs& decided, const PairVerdict& pair) {
  const auto joint = joint_of_neighbours(decided.model, pair.a, pair.b);
  return joint && decided.late_joints.count(*joint) != 0 ? joint : std::nullopt;
}

/// The verdict on a line that disables the pair.
LineVerdict line_verdict(const DecidedPairs& decided, const PairVerdict& pair) {
  if (pair.zone) {
    return LineVerdict::contact;
  }
  switch (pair.verdict) {
    case MatrixVerdict::never:
      return LineVerdict::proven;
    case MatrixVerdict::fixed:
      return is_in_contact(decided, pair) ? LineVerdict::contact : LineVerdict::proven;
    case MatrixVerdict::can:
    case MatrixVerdict::believed:
      return is_in_contact(decided, pair) ? LineVerdict::contact
             : late_joint(decided, pair)  ? LineVerdict::undecided
                                          : LineVerdict::refuted;
    case MatrixVerdict::undecided:
      break;
  }
  return LineVerdict::undecided;
}

/// The SRDF's reason for disabling the pair, or null if planners have to check it. "Never" only of
/// whole links that never collide, "Default" only of links that intersect at the default
/// configuration.
const char* reason_of(const DecidedPairs& decided, const PairVerdict& pair, LineVerdict verdict) {
  const auto& adjacent = decided.model.adjacent;
  if (verdict != LineVerdict::proven && verdict != LineVerdict::contact) {
    return nullptr;
  }
  if (std::find(adjacent.begin(), adjacent.end(), std::pair(pair.a, pair.b)) != adjacent.end()) {
    return "Adjacent";
  }
  return verdict == LineVerdict::proven                           ? "Never"
         : pair.verdict == MatrixVerdict::fixed                   ? "Always"
         : intersect_at_default(decided, space_of(decided, pair)) ? "Default"
                                                                  : "User";
}

FileTriangle file_triangle(const ModelLink& link, std::size_t triangle) {
  const auto next =
      std::upper_bound(link.source_begins.begin(), link.source_begins.end(), triangle);
  const auto source = static_cast<std::size_t>(next - link.source_begins.begin()) - 1;
  return {link.sources[source], triangle - link.source_begins[source]};
}

std::string why_of(const DecidedPairs& decided, const PairVerdict& pair, LineVerdict verdict) {
  if (verdict == LineVerdict::contact && !pair.zone && pair.verdict != MatrixVerdict::fixed) {
    return "intersect at the default configuration and wherever tried; sampled, not proven";
  }
  const std::optional<std::size_t> late = late_joint(decided, pair);
  return verdict == LineVerdict::undecided && late
             ? "no time was left to find a zone about " + decided.model.joints[*late].name
             : pair.reason;
}

void add_witness(const DecidedPairs& decided, AuditedLine& line) {
  const Model& model = decided.model;
  const auto found = triangles_at(model, decided.meshes.data(), decided.cell, line.pair).triangles;
  line.triangles = {file_triangle(model.links[line.pair.a], found.a),
                    file_triangle(model.links[line.pair.b], found.b)};
  line.why = concat("intersect at ", witness_text(model, line.pair), "; triangle ",
                    line.triangles[0].triangle, " of ", line.triangles[0].source, " and triangle ",
                    line.triangles[1].triangle, " of ", line.triangles[1].source);
}

std::string xml_text(const std::string& name) {
  std::string text;
  for (const char c : name) {
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return text;
}

}  // namespace

const char* name_of(LineVerdict verdict) {
  constexpr const char* kNames[] = {"proven", "contact", "refuted", "undecided"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::size_t Audit::count(LineVerdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(),
                    [&](const AuditedLine& line) { return line.verdict == verdict; }));
}

std::vector<SrdfLine> srdf_lines(const DecidedPairs& decided) {
  std::vector<SrdfLine> lines;
  for (const PairVerdict& pair : decided.pairs) {
    if (const char* reason = reason_of(decided, pair, line_verdict(decided, pair))) {
      lines.push_back({pair.a, pair.b, reason});
    }
  }
  return lines;
}

std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines) {
  std::string text =
      concat("<?xml version=\"1.0\"?>\n<robot name=\"", xml_text(model.name), "\">\n");
  for (const SrdfLine& line : lines) {
    text +=
        concat("  <disable_collisions link1=\"", xml_text(model.links[line.a].name), "\" link2=\"",
               xml_text(model.links[line.b].name), "\" reason=\"", line.reason, "\"/>\n");
  }
  return text + "</robot>\n";
}

Audit audit_of(const DecidedPairs& decided, const std::vector<DisabledPair>& disabled) {
  Audit audit;
  for (const DisabledPair& of : disabled) {
    const PairVerdict& pair = *find_pair(decided.pairs, of.a, of.b);
    const LineVerdict verdict = line_verdict(decided, pair);
    audit.lines.push_back({of, pair, verdict, why_of(decided, pair, verdict), {}});
    if (verdict == LineVerdict::refuted) {
      add_witness(decided, audit.lines.back());
    }
  }
  for (const SrdfLine& line : srdf_lines(decided)) {
    if (find_pair(disabled, line.a, line.b) == nullptr) {
      const PairVerdict& pair = *find_pair(decided.pairs, line.a, line.b);
      audit.missing.push_back({line, why_of(decided, pair, line_verdict(decided, pair))});
    }
  }
  return audit;
}

std::string summary_of(const Audit& audit) {
  std::string text = concat(audit.lines.size(), audit.lines.size() == 1 ? " line: " : " lines: ");
  const char* between = "";
  for (const LineVerdict verdict :
       {LineVerdict::proven, LineVerdict::contact, LineVerdict::refuted, LineVerdict::undecided}) {
    text += concat(between, audit.count(verdict), " ", name_of(verdict));
    between = ", ";
  }
  return concat(text, "; ", audit.missing.size(),
                audit.missing.size() == 1 ? " pair is missing" : " pairs are missing");
}

}  // namespace flashbvh::tool
