#include "robot/audit/audit.hpp"

#include <algorithm>

#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/numbers.hpp"
#include "text/xml.hpp"

namespace flashbvh::tool {
namespace {

/// In reasons of pairs that can collide.
constexpr std::string_view kTheWitness = "the witness";

/// MoveIt's default: 0, or the middle of the limits if they exclude 0.
double default_value(const ModelJoint& joint) {
  return joint.lower <= 0 && joint.upper >= 0 ? 0 : 0.5 * (joint.lower + joint.upper);
}

FileTriangle file_triangle(const ModelLink& link, std::size_t triangle) {
  const auto next =
      std::upper_bound(link.source_begins.begin(), link.source_begins.end(), triangle);
  const auto source = static_cast<std::size_t>(next - link.source_begins.begin()) - 1;
  return {link.sources[source], triangle - link.source_begins[source]};
}

/// Judges lines that disable a decided pair.
class Auditor {
 public:
  Auditor(const Prepared& robot, const Decided& decided) : robot_(robot), decided_(decided) {}

  AuditedLine audited(const DisabledPair& line, const PairVerdict& pair) const {
    const LineVerdict verdict = verdict_on(pair, &line);
    AuditedLine made = {line, with_witness(pair, verdict), verdict, "", {}};
    made.why = why(made.pair, verdict);
    if (verdict == LineVerdict::refuted) {
      add_triangles(made);
    }
    return made;
  }

  /// The line that may disable the pair, if planners need not check it or the SRDF's `line` is
  /// believed.
  std::optional<SrdfLine> valid_line(const PairVerdict& pair, const DisabledPair* line) const {
    const LineVerdict verdict = verdict_on(pair, line);
    if (verdict != LineVerdict::proven && verdict != LineVerdict::contact &&
        verdict != LineVerdict::believed) {
      return std::nullopt;
    }
    return SrdfLine{pair.a, pair.b, reason(pair, verdict),
                    why(with_witness(pair, verdict), verdict)};
  }

 private:
  PairSpace space_of(const PairVerdict& pair) const {
    return {robot_.model,
            {pair.a, robot_.wholes[pair.a].view()},
            {pair.b, robot_.wholes[pair.b].view()},
            robot_.cell};
  }

  /// The values of the variables at the default configuration; none if the links don't intersect
  /// there.
  std::vector<double> contact_at_default(const PairVerdict& pair) const {
    const PairSpace space = space_of(pair);
    std::vector<double> point;
    for (const Dimension& dimension : space.dimensions()) {
      point.push_back(
          default_value(robot_.model.joints[robot_.model.variables[dimension.variable]]));
    }
    return space.intersect(point) ? space.variables_at(point) : std::vector<double>();
  }

  /// True if the links intersect at the default configuration and at every other one that is tried.
  bool is_in_contact(const PairVerdict& pair) const {
    return !contact_at_default(pair).empty() &&
           intersect_wherever_tried(space_of(pair), MatrixOptions{}.looks);
  }

  PairVerdict with_witness(PairVerdict pair, LineVerdict verdict) const {
    if (verdict == LineVerdict::at_default ||
        (verdict == LineVerdict::contact && pair.witness.empty())) {
      pair.witness = contact_at_default(pair);
    }
    return pair;
  }

  /// The joint between two neighbours if the search for its zone ran out of time: a collision may
  /// lie in the zone and refutes nothing.
  std::optional<std::size_t> late_joint(const PairVerdict& pair) const {
    const auto joint = joint_of_neighbours(robot_.model, pair.a, pair.b);
    return joint && decided_.late_joints.count(*joint) != 0 ? joint : std::nullopt;
  }

  /// `line`: of the SRDF, or null.
  LineVerdict verdict_on(const PairVerdict& pair, const DisabledPair* line) const {
    const LineVerdict verdict = verdict_on(pair);
    if (line == nullptr || verdict < LineVerdict::refuted) {
      return verdict;
    }
    return line->is_believed ? LineVerdict::believed
           : line->reason == "Default" && !contact_at_default(pair).empty()
               ? LineVerdict::at_default
               : verdict;
  }

  LineVerdict verdict_on(const PairVerdict& pair) const {
    if (pair.zone) {
      return LineVerdict::contact;
    }
    switch (pair.verdict) {
      case MatrixVerdict::never:
        return LineVerdict::proven;
      case MatrixVerdict::fixed:
        return is_in_contact(pair) ? LineVerdict::contact : LineVerdict::proven;
      case MatrixVerdict::can:
      case MatrixVerdict::believed:
        return is_in_contact(pair) ? LineVerdict::contact
               : late_joint(pair)  ? LineVerdict::undecided
                                   : LineVerdict::refuted;
      case MatrixVerdict::undecided:
        break;
    }
    return LineVerdict::undecided;
  }

  /// "Never" only for whole links that never collide, "Default" only for links that intersect at
  /// the default configuration.
  const char* reason(const PairVerdict& pair, LineVerdict verdict) const {
    const auto& adjacent = robot_.model.adjacent;
    const std::pair links(pair.a, pair.b);
    return std::find(adjacent.begin(), adjacent.end(), links) != adjacent.end() ? "Adjacent"
           : verdict == LineVerdict::proven                                     ? "Never"
           : pair.verdict == MatrixVerdict::fixed                               ? "Always"
           : !contact_at_default(pair).empty()                                  ? "Default"
                                                                                : "User";
  }

  std::string why(const PairVerdict& pair, LineVerdict verdict) const {
    const std::string at = pair.witness.empty() ? "" : witness_text(robot_.model, pair);
    if (verdict == LineVerdict::at_default) {
      return concat("intersect at the default configuration, ", at,
                    ", as it says; at others they may be apart");
    }
    if (verdict == LineVerdict::contact && !pair.zone && pair.verdict != MatrixVerdict::fixed) {
      return "intersect at the default configuration and wherever tried; sampled, not proven";
    }
    const std::optional<std::size_t> late = late_joint(pair);
    if (verdict == LineVerdict::undecided && late) {
      return "no time was left to find a zone about " + robot_.model.joints[*late].name;
    }
    std::string text = pair.reason;
    if (const std::size_t found = text.find(kTheWitness); found != std::string::npos) {
      return text.replace(found, kTheWitness.size(), at);
    }
    return text + (at.empty() ? "" : "; touch inside at " + at);
  }

  void add_triangles(AuditedLine& line) const {
    const Model& model = robot_.model;
    const auto found = triangles_at(model, views_of(robot_.wholes), robot_.cell, line.pair);
    line.triangles = {file_triangle(model.links[line.pair.a], found.a),
                      file_triangle(model.links[line.pair.b], found.b)};
    line.why +=
        concat("; triangle ", line.triangles[0].triangle, " of ", line.triangles[0].source,
               " and triangle ", line.triangles[1].triangle, " of ", line.triangles[1].source);
  }

  const Prepared& robot_;
  const Decided& decided_;
};

}  // namespace

const char* name_of(LineVerdict verdict) {
  constexpr const char* kNames[] = {"proven",   "contact", "default",
                                    "believed", "refuted", "undecided"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::size_t Audit::count(LineVerdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(),
                    [&](const AuditedLine& line) { return line.verdict == verdict; }));
}

std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines) {
  std::string text =
      concat("<?xml version=\"1.0\"?>\n<robot name=\"", xml_value(model.name), "\">\n");
  for (const SrdfLine& line : lines) {
    text +=
        concat("  <disable_collisions link1=\"", xml_value(model.links[line.a].name), "\" link2=\"",
               xml_value(model.links[line.b].name), "\" reason=\"", line.reason, "\"/>\n");
  }
  return text + "</robot>\n";
}

Audit audit_of(const Prepared& robot, const Decided& decided,
               const std::vector<DisabledPair>& disabled) {
  const Auditor auditor(robot, decided);
  Audit audit;
  for (const DisabledPair& line : disabled) {
    audit.lines.push_back(auditor.audited(line, *find_pair(decided.pairs, line.a, line.b)));
  }
  for (const PairVerdict& pair : decided.pairs) {
    const DisabledPair* const disabling = find_pair(disabled, pair.a, pair.b);
    if (const std::optional<SrdfLine> line = auditor.valid_line(pair, disabling)) {
      audit.valid.push_back(*line);
      if (disabling == nullptr) {
        audit.missing.push_back(*line);
      }
    }
  }
  return audit;
}

}  // namespace flashbvh::tool
