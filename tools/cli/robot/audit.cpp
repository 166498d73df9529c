// flashbvh audit: reports which pairs of links an SRDF may disable.
#include <iostream>

#include "cli/commands.hpp"
#include "cli/robot/robot_options.hpp"
#include "cli/robot/robot_output.hpp"
#include "cli/table.hpp"
#include "robot/audit/audit.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct AuditArguments : RobotRequest {
  std::string written;
  bool json = false;
};

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
               {"witness", witness_json(model, line.pair)},
               {"triangles", Json::array()}};
  if (line.verdict == LineVerdict::refuted) {
    json["triangles"] = {triangle_json(line.triangles[0]), triangle_json(line.triangles[1])};
  }
  return json;
}

Json audit_json(const Model& model, const std::string& srdf, const Audit& audit,
                const Warnings& warnings) {
  Json json = {
      {"robot", model.name}, {"srdf", srdf}, {"ok", audit.count(LineVerdict::refuted) == 0}};
  for (const LineVerdict verdict : kLineVerdicts) {
    json[name_of(verdict)] = audit.count(verdict);
  }
  json["lines"] = Json::array();
  for (const AuditedLine& line : audit.lines) {
    json["lines"].push_back(line_json(model, line));
  }
  json["missing"] = Json::array();
  for (const SrdfLine& line : audit.missing) {
    json["missing"].push_back({{"a", model.links[line.a].name},
                               {"b", model.links[line.b].name},
                               {"srdf_reason", line.reason},
                               {"reason", line.why}});
  }
  json["warnings"] = json_of(warnings);
  return json;
}

/// "64 lines: 60 proven, 3 contact, 0 default, 0 believed, 1 refuted, 0 undecided; 2 pairs are
/// missing".
std::string audit_summary(const Json& audit) {
  const std::size_t lines = audit["lines"].size();
  const std::size_t missing = audit["missing"].size();
  const auto count = [&](LineVerdict verdict) {
    return concat(audit[name_of(verdict)].get<std::size_t>(), " ", name_of(verdict));
  };
  return concat(lines, lines == 1 ? " line: " : " lines: ", joined(kLineVerdicts, count), "; ",
                missing, missing == 1 ? " pair is missing" : " pairs are missing");
}

/// `place`: the SRDF, or the robot without one.
void print_audit(const Json& json, const std::string& place) {
  const Column srdf = {"SRDF", [](const Json& row) {
                         const std::string reason = row["srdf_reason"];
                         return reason.empty() ? "-" : reason;
                       }};
  print_table(json["lines"], {pair_column("pair"), number_column("line", "line"), srdf,
                              word_column("verdict", "verdict"), word_column("reason", "reason")});
  std::cout << (json["lines"].empty() ? "" : "\n");
  print_table(json["missing"], {pair_column("missing"), srdf, word_column("reason", "reason")});
  std::cout << (json["missing"].empty() ? "" : "\n") << place << ": " << audit_summary(json)
            << "\n";
}

ExitCode audit_srdf(const AuditArguments& arguments) {
  Warnings warnings;
  Model model = described_robot(arguments, warnings);
  const std::vector<DisabledPair> disabled = std::exchange(model.disabled, {});
  Progress progress(steps_of(model));
  const Prepared robot = prepare(std::move(model), arguments, shown_by(progress), warnings);
  const Decided decided = decide(robot, arguments, 0, "undecided", shown_by(progress), warnings);
  const Audit audit = audit_of(robot, decided, disabled);
  for (const AuditedLine& line : audit.lines) {
    if (line.line.is_believed && line.verdict != LineVerdict::believed) {
      warnings.add(
          at_line(arguments.srdf, line.line.line),
          concat("is ", name_of(line.verdict), ", with or without --believe; leave that out"));
    }
  }
  FileSet files(files_read(arguments, robot.model));
  if (!arguments.written.empty()) {
    files.add(arguments.written, srdf_of(robot.model, audit.valid));
  }
  files.write([&] {
    warnings.print();
    const Json json = audit_json(robot.model, arguments.srdf, audit, warnings);
    if (arguments.json) {
      print_object(json);
    } else {
      print_audit(json, arguments.srdf.empty() ? arguments.urdf : arguments.srdf);
    }
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
  add_option(command, "SRDF", a.srdf, "FILE.srdf", "The SRDF of the robot, if it has one");
  add_believe(command, a, "Two links whose line holds though they can collide; may be repeated");
  add_time(command, a, "What is not decided by then is undecided");
  add_option(command, "--write", a.written, "FIXED.srdf",
             "Write an SRDF of all pairs that no planner has to check, and of nothing else");
  command.add_flag("--json", a.json, "One JSON object");
  add_example(command, "audit arm.urdf --write arm.srdf",
              "writes arm.srdf, and prints what it disables");
}

}  // namespace flashbvh::tool
