#include "report/arm_pictures.hpp"
#include "report/html.hpp"
#include "report/robot_page.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::array<MatrixVerdict, 6> kVerdicts = {MatrixVerdict::never,  MatrixVerdict::can,
                                                    MatrixVerdict::always, MatrixVerdict::undecided,
                                                    MatrixVerdict::fixed,  MatrixVerdict::believed};
constexpr std::array<const char*, 6> kMeanings = {"proven to collide nowhere",
                                                  "collide at this share of random configurations",
                                                  "intersect wherever they were tried, not guarded",
                                                  "neither proven nor found to collide",
                                                  "no joint moves them",
                                                  "disabled in the SRDF, not guarded"};

/// What fits a cell: how often, or how it is known.
std::string short_reason(const PairVerdict& pair, const std::string& share) {
  return pair.verdict == MatrixVerdict::can ? share
         : pair.verdict == MatrixVerdict::always || pair.verdict == MatrixVerdict::believed
             ? "not guarded"
         : pair.verdict == MatrixVerdict::fixed
             ? escaped(pair.reason.substr(pair.reason.rfind(' ') + 1))  // apart, intersecting
             : counted(pair.cells, "cell", "cells") + (pair.is_guarded ? ", guarded" : "");
}

std::string cell(const PairVerdict& pair, const std::string& share) {
  return concat("<td class=is-", name_of(pair.verdict), ">", name_of(pair.verdict), "<small>",
                short_reason(pair, share), "</small></td>");
}

std::string matrix_of(const DecidedRobot& decided, const std::vector<std::string>& shares) {
  const std::vector<ModelLink>& links = decided.model.links;
  std::vector<std::vector<std::string>> cells(
      links.size(), std::vector<std::string>(links.size(), "<td>&ndash;</td>"));
  for (std::size_t i = 0; i < decided.pairs.size(); ++i) {
    const PairVerdict& pair = decided.pairs[i];
    cells[pair.a][pair.b] = cells[pair.b][pair.a] = cell(pair, shares[i]);
  }
  std::string head;
  std::string body;
  for (std::size_t a = 0; a < links.size(); ++a) {
    const std::string name = escaped(links[a].name);
    head += "<th scope=col>" + name + "</th>";
    body += "<tr><th scope=row>" + name + "</th>";
    for (const std::string& html : cells[a]) {
      body += html;
    }
    body += "</tr>\n";
  }
  return "<div class=scroll><table class=\"matrix pairs\"><thead><tr><td></td>" + head +
         "</tr></thead>\n<tbody>\n" + body + "</tbody></table></div>\n";
}

std::string keys() {
  std::string html = "<p class=keys>";
  for (std::size_t i = 0; i < kVerdicts.size(); ++i) {
    const std::string name = name_of(kVerdicts[i]);
    html += key("is-" + name, "<b>" + name + "</b>: " + kMeanings[i]);
  }
  return html + "</p>\n";
}

std::string words(const DecidedRobot& decided) {
  std::vector<std::vector<std::string>> rows;
  for (const PairVerdict& pair : decided.pairs) {
    rows.push_back({links_of(decided.model, pair.a, pair.b), name_of(pair.verdict),
                    pair.is_guarded ? "guarded" : "&ndash;", grouped(pair.cells),
                    escaped(pair.reason)});
  }
  return "<div class=words>\n" +
         table(
             "Each pair, how many cells of joint values were looked at in all, and what it was "
             "decided by",
             {{"links", false},
              {"collide", false},
              {"guard", false},
              {"cells in all", true},
              {"reason", false}},
             rows) +
         "</div>\n";
}

}  // namespace

std::string matrix_section(const DecidedRobot& decided, const std::vector<std::string>& shares) {
  if (decided.pairs.empty()) {
    return "";
  }
  return "<section id=matrix><h2>What can collide</h2>\n" + keys() + matrix_of(decided, shares) +
         words(decided) + "</section>\n";
}

std::string matrix_style() {
  // Behind text of either scheme.
  return ".is-never{background:rgba(40,160,90,.2)}.is-can{background:rgba(var(--hot),.34)}\n"
         ".is-always,.is-believed{background:rgba(220,160,20,.3)}"
         ".is-fixed{background:rgba(130,145,165,.22)}"
         ".is-undecided{background:rgba(160,80,200,.28)}\n"
         ".pairs td{text-align:center;border:2px solid var(--paper);line-height:1.25}\n"
         ".pairs td small{display:block;color:var(--text);white-space:nowrap}\n"
         ".pairs tbody th{white-space:nowrap;padding-right:10px;position:sticky;left:0;"
         "background:var(--paper)}\n"
         ".pairs thead th{text-align:center}.key.is-can,.key.is-never,.key.is-always,"
         ".key.is-undecided,.key.is-fixed,.key.is-believed{outline:1px solid var(--soft)}\n"
         "@media (max-width:539px){.pairs tbody th,.pairs thead th{white-space:normal;"
         "overflow-wrap:anywhere;min-width:5.5em;max-width:7em}"
         ".words tr{display:grid;border-bottom:1px solid var(--line);"
         "grid-template-columns:1fr 5em 4.4em 4.4em;padding:4px 0}"
         ".words :is(td,th){border:0;padding:1px 0}.words thead th:last-child{display:none}"
         ".words td:last-child{grid-column:1/-1;color:var(--soft)}}\n"
         "@media print{td,.key{print-color-adjust:exact;-webkit-print-color-adjust:exact}"
         "figure,tr{break-inside:avoid}}\n";
}

}  // namespace flashbvh::tool
