#include "robot/audit/audit.hpp"

#include <algorithm>

#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

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
    const LineVerdict verdict = verdict_on(pair);
    AuditedLine made = {line, pair, verdict, why(pair, verdict), {}};
    if (verdict == LineVerdict::refuted) {
      add_witness(made);
    }
    return made;
  }

  /// The line that may disable the pair, if planners need not check it.
  std::optional<SrdfLine> valid_line(const PairVerdict& pair) const {
    const LineVerdict verdict = verdict_on(pair);
    if (verdict != LineVerdict::proven && verdict != LineVerdict::contact) {
      return std::nullopt;
    }
    return SrdfLine{pair.a, pair.b, reason(pair, verdict), why(pair, verdict)};
  }

 private:
  PairSpace space_of(const PairVerdict& pair) const {
    return {robot_.model,
            {pair.a, robot_.wholes[pair.a].view()},
            {pair.b, robot_.wholes[pair.b].view()},
            robot_.cell};
  }

  /// True if the links intersect at the default configuration.
  bool intersect_at_default(const PairSpace& space) const {
    std::vector<double> at_default;
    for (const Dimension& dimension : space.dimensions()) {
      at_default.push_back(
          default_value(robot_.model.joints[robot_.model.variables[dimension.variable]]));
    }
    return space.intersect(at_default);
  }

  /// True if the links intersect at the default configuration and at every other one that is tried.
  bool is_in_contact(const PairVerdict& pair) const {
    const PairSpace space = space_of(pair);
    return intersect_at_default(space) && intersect_wherever_tried(space, MatrixOptions{}.looks);
  }

  /// The joint between two neighbours if the search for its zone ran out of time: a collision may
  /// lie in the zone and refutes nothing.
  std::optional<std::size_t> late_joint(const PairVerdict& pair) const {
    const auto joint = joint_of_neighbours(robot_.model, pair.a, pair.b);
    return joint && decided_.late_joints.count(*joint) != 0 ? joint : std::nullopt;
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
           : intersect_at_default(space_of(pair))                               ? "Default"
                                                                                : "User";
  }

  std::string why(const PairVerdict& pair, LineVerdict verdict) const {
    if (verdict == LineVerdict::contact && !pair.zone && pair.verdict != MatrixVerdict::fixed) {
      return "intersect at the default configuration and wherever tried; sampled, not proven";
    }
    const std::optional<std::size_t> late = late_joint(pair);
    return verdict == LineVerdict::undecided && late
               ? "no time was left to find a zone about " + robot_.model.joints[*late].name
               : pair.reason;
  }

  void add_witness(AuditedLine& line) const {
    const Model& model = robot_.model;
    const auto found = triangles_at(model, views_of(robot_.wholes), robot_.cell, line.pair);
    line.triangles = {file_triangle(model.links[line.pair.a], found.a),
                      file_triangle(model.links[line.pair.b], found.b)};
    line.why =
        concat("intersect at ", witness_text(model, line.pair), "; triangle ",
               line.triangles[0].triangle, " of ", line.triangles[0].source, " and triangle ",
               line.triangles[1].triangle, " of ", line.triangles[1].source);
  }

  const Prepared& robot_;
  const Decided& decided_;
};

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

Audit audit_of(const Prepared& robot, const Decided& decided,
               const std::vector<DisabledPair>& disabled) {
  const Auditor auditor(robot, decided);
  Audit audit;
  for (const DisabledPair& line : disabled) {
    audit.lines.push_back(auditor.audited(line, *find_pair(decided.pairs, line.a, line.b)));
  }
  for (const PairVerdict& pair : decided.pairs) {
    if (const std::optional<SrdfLine> line = auditor.valid_line(pair)) {
      audit.valid.push_back(*line);
      if (find_pair(disabled, pair.a, pair.b) == nullptr) {
        audit.missing.push_back(*line);
      }
    }
  }
  return audit;
}

}  // namespace flashbvh::tool
