#include "report/audit_page.hpp"

#include <filesystem>

#include "report/html.hpp"
#include "report/links.hpp"

namespace flashbvh::tool {
namespace {

/// The style class for a line's verdict by the matrix.
std::string style_of(LineVerdict verdict) {
  constexpr const char* kStyles[] = {"is-never", "is-contact", "is-can", "is-undecided"};
  return kStyles[static_cast<std::size_t>(verdict)];
}

std::string lines_section(const Model& model, const Audit& audit) {
  std::vector<Cells> rows;
  for (const AuditedLine& line : audit.lines) {
    rows.push_back({links_of(model, line.pair.a, line.pair.b), grouped(line.line.line),
                    escaped(line.line.reason), key(style_of(line.verdict), name_of(line.verdict)),
                    escaped(line.why)});
  }
  return rows.empty() ? ""
                      : section("lines", "What the SRDF disables",
                                table("", {"links", "#line", "SRDF", "verdict", "reason"}, rows));
}

std::string missing_section(const Model& model, const Audit& audit) {
  std::vector<Cells> rows;
  for (const MissingLine& missing : audit.missing) {
    rows.push_back({links_of(model, missing.line.a, missing.line.b), missing.line.reason,
                    escaped(missing.why)});
  }
  return rows.empty() ? ""
                      : section("missing", "What planners check for nothing",
                                table("", {"links", "SRDF", "reason"}, rows));
}

}  // namespace

std::string audit_page(const Model& model, const std::string& srdf, const Audit& audit) {
  const bool is_refuted = audit.count(LineVerdict::refuted) != 0;
  const bool is_undecided = audit.count(LineVerdict::undecided) != 0;
  return page(escaped(model.name), "audit", "which pairs of an SRDF may be disabled",
              decision_section("The SRDF",
                               decision(is_refuted     ? "v3"
                                        : is_undecided ? "v2"
                                                       : "v0",
                                        is_refuted     ? "Lines are refuted"
                                        : is_undecided ? "Lines are undecided"
                                                       : "No line is refuted",
                                        escaped(std::filesystem::path(srdf).filename().string() +
                                                ": " + summary_of(audit)))) +
                  lines_section(model, audit) + missing_section(model, audit) + footer());
}

}  // namespace flashbvh::tool
