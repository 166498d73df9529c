// flashbvh audit: reports which pairs of links an SRDF may disable.
#include <iomanip>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"
#include "cli/robot/robot_arguments.hpp"
#include "robot/audit/audit.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct AuditArguments : RobotArguments {
  std::string written;
  bool json = false;
};

/// Prints a table in columns as wide as their widest cell, and an empty line; nothing if there are
/// no rows below the heading. The last column is not padded.
void print_columns(const std::vector<std::vector<std::string>>& rows) {
  if (rows.size() == 1) {
    return;
  }
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size() + 2);
    }
  }
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::cout << std::left << std::setw(static_cast<int>(widths[i])) << row[i];
    }
    std::cout << "\n";
  }
  std::cout << "\n";
}

std::string pair_text(const Model& model, std::size_t a, std::size_t b) {
  return model.links[a].name + " - " + model.links[b].name;
}

void print_audit(const Model& model, const std::string& srdf, const Audit& audit) {
  std::vector<std::vector<std::string>> lines = {{"pair", "line", "SRDF", "verdict", "reason"}};
  for (const AuditedLine& line : audit.lines) {
    lines.push_back({pair_text(model, line.pair.a, line.pair.b), concat(line.line.line),
                     line.line.reason.empty() ? "-" : line.line.reason, name_of(line.verdict),
                     line.why});
  }
  print_columns(lines);
  std::vector<std::vector<std::string>> missing = {{"missing", "SRDF", "reason"}};
  for (const MissingLine& line : audit.missing) {
    missing.push_back({pair_text(model, line.line.a, line.line.b), line.line.reason, line.why});
  }
  print_columns(missing);
  std::cout << srdf << ": " << summary_of(audit) << "\n";
}

Json triangle_json(const FileTriangle& triangle) {
  return {{"source", triangle.source}, {"triangle", triangle.triangle}};
}

Json line_json(const Model& model, const AuditedLine& line) {
  Json json = {{"line", line.line.line},
               {"a", model.links[line.pair.a].name},
               {"b", model.links[line.pair.b].name},
               {"srdf_reason", line.line.reason},
               {"verdict", name_of(line.verdict)},
               {"reason", line.why},
               {"cells", line.pair.joint_boxes},
               {"witness", Json::object()},
               {"triangles", Json::array()}};
  if (line.verdict == LineVerdict::refuted) {
    for (std::size_t i = 0; i < line.pair.witness.size(); ++i) {
      json["witness"][model.joints[model.variables[i]].name] = line.pair.witness[i];
    }
    json["triangles"] = {triangle_json(line.triangles[0]), triangle_json(line.triangles[1])};
  }
  return json;
}

void print_audit_json(const Model& model, const std::string& srdf, const Audit& audit,
                      const Warnings& warnings) {
  Json json = {{"robot", model.name},
               {"srdf", srdf},
               {"ok", audit.count(LineVerdict::refuted) == 0},
               {"proven", audit.count(LineVerdict::proven)},
               {"contact", audit.count(LineVerdict::contact)},
               {"refuted", audit.count(LineVerdict::refuted)},
               {"undecided", audit.count(LineVerdict::undecided)},
               {"lines", Json::array()},
               {"missing", Json::array()}};
  for (const AuditedLine& line : audit.lines) {
    json["lines"].push_back(line_json(model, line));
  }
  for (const MissingLine& missing : audit.missing) {
    json["missing"].push_back({{"a", model.links[missing.line.a].name},
                               {"b", model.links[missing.line.b].name},
                               {"srdf_reason", missing.line.reason},
                               {"reason", missing.why}});
  }
  json["warnings"] = json_of(warnings);
  print_object(json);
}

ExitCode audit_srdf(const AuditArguments& arguments) {
  Warnings warnings;
  Model model = described_robot(arguments, warnings);
  const std::vector<DisabledPair> disabled = std::exchange(model.disabled, {});
  const BakedRobot robot = decided_robot(std::move(model), arguments, warnings);
  const std::vector<WholeMesh> meshes = views_of(robot.wholes);
  const DecidedPairs decided = {robot.model, meshes, robot.cell, robot.pairs, robot.late_joints};
  const Audit audit = audit_of(decided, disabled);
  FileSet files(files_read(arguments, robot.model));
  if (!arguments.written.empty()) {
    files.add(arguments.written, srdf_of(robot.model, srdf_lines(decided)));
  }
  files.write([&] {
    warnings.print();
    if (arguments.json) {
      print_audit_json(robot.model, arguments.srdf, audit, warnings);
    } else {
      print_audit(robot.model, arguments.srdf, audit);
    }
    flush_output();
  });
  return audit.count(LineVerdict::refuted) == 0 ? kSuccess : kCheckFailed;
}

}  // namespace

void add_audit(CLI::App& app) {
  auto [command, a] = add_command<AuditArguments>(
      app, "audit",
      "Decide each pair of links that an SRDF disables, and list the pairs that it could disable.\n"
      "Exit code 0: no line is refuted; 1: in some two links can collide.",
      audit_srdf);
  add_described_options(command, "ROBOT", a);
  add_option(command, "SRDF", a.srdf, "FILE.srdf", "The SRDF of the robot")->required();
  add_time(command, a, "What is not decided by then is undecided");
  add_option(command, "--write", a.written, "FIXED.srdf",
             "Write an SRDF of all pairs that no planner has to check, and of nothing else");
  add_json(command, a.json, "One JSON object");
  add_progress(command, a.progress);
  add_example(command, "audit arm.urdf arm.srdf", "prints a verdict for each disabled pair");
}

}  // namespace flashbvh::tool
