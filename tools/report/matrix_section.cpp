#include "report/arm_pictures.hpp"
#include "report/html.hpp"
#include "report/robot_page.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::pair<MatrixVerdict, const char*> kMeanings[] = {
    {MatrixVerdict::never, "proven to collide nowhere"},
    {MatrixVerdict::can, "collide at this share of random configurations"},
    {MatrixVerdict::always, "intersect wherever they were tried, not guarded"},
    {MatrixVerdict::undecided, "neither proven nor found to collide"},
    {MatrixVerdict::fixed, "no joint moves them"},
    {MatrixVerdict::believed, "disabled in the SRDF, not guarded"}};

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
  Cells names;
  for (const ModelLink& link : decided.model.links) {
    names.push_back(escaped(link.name));
  }
  std::vector<Cells> cells(names.size(), Cells(names.size(), "<td>&ndash;</td>"));
  for (std::size_t i = 0; i < decided.pairs.size(); ++i) {
    const PairVerdict& pair = decided.pairs[i];
    cells[pair.a][pair.b] = cells[pair.b][pair.a] = cell(pair, shares[i]);
  }
  return matrix("pairs", "", names, names,
                [&](std::size_t a, std::size_t b) { return cells[a][b]; });
}

std::string keys() {
  std::string html = "<p class=keys>";
  for (const auto& [verdict, meaning] : kMeanings) {
    const std::string name = name_of(verdict);
    html += key("is-" + name, "<b>" + name + "</b>: " + meaning);
  }
  return html + "</p>\n";
}

std::string words(const DecidedRobot& decided) {
  std::vector<Cells> rows;
  for (const PairVerdict& pair : decided.pairs) {
    rows.push_back({links_of(decided.model, pair.a, pair.b), name_of(pair.verdict),
                    pair.is_guarded ? "guarded" : "&ndash;", grouped(pair.cells),
                    escaped(pair.reason)});
  }
  return "<div class=words>\n" +
         table(
             "Each pair, how many cells of joint values were looked at in all, and what it was "
             "decided by",
             {"links", "collide", "guard", "#cells in all", "reason"}, rows) +
         "</div>\n";
}

}  // namespace

std::string matrix_section(const DecidedRobot& decided, const std::vector<std::string>& shares) {
  if (decided.pairs.empty()) {
    return "";
  }
  return section("matrix", "What can collide",
                 keys() + matrix_of(decided, shares) + words(decided));
}

}  // namespace flashbvh::tool
