#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "evaluate/poses.hpp"
#include "report/html.hpp"
#include "report/page.hpp"
#include "report/standing.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string pose_text(const QueriedPair& pair, const PoseCost& cost, const char* name) {
  const std::string found = cost.triangle_pairs == 0
                                ? "no triangles intersect"
                                : counted(cost.triangle_pairs, "pair of triangles intersects",
                                          "pairs of triangles intersect");
  return concat("<p><b", shown_at(pair, cost.pose), ">", name, ":</b> ", grouped(cost.work),
                " work; ", found, "</p><p class=note><code>",
                line_of(cost.pose, pair.a->image.cell()), "</code></p>\n");
}

std::string pose_texts(const QueriedPair& pair) {
  const std::vector<PoseCost>& poses = pair.costs.poses;
  const auto most =
      std::max_element(poses.begin(), poses.end(),
                       [](const PoseCost& p, const PoseCost& q) { return p.work < q.work; });
  // 0 - 1 wraps, so poses without intersection sort to the end.
  const auto first =
      std::min_element(poses.begin(), poses.end(), [](const PoseCost& p, const PoseCost& q) {
        return p.triangle_pairs - 1 < q.triangle_pairs - 1;
      });
  return "<h3>" + title_of(pair) + "</h3>\n" + pose_text(pair, *most, "Costliest pose") +
         (first->triangle_pairs != 0 ? pose_text(pair, *first, "First contact")
                                     : note("At none of the poses do they intersect."));
}

const QueriedPair* find(const std::vector<QueriedPair>& pairs, const Subject* a, const Subject* b) {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const QueriedPair& pair) {
    return pair.a == a && pair.b == b;
  });
  return found == pairs.end() ? nullptr : &*found;
}

/// A cell that is darker the more work its pair needs.
std::string matrix_cell(const QueriedPair* pair, std::uint64_t most) {
  if (pair == nullptr) {
    return "<td class=n>&ndash;</td>";
  }
  const std::uint64_t work = pair->costs.needed.most;
  const double share = static_cast<double>(work) / static_cast<double>(most);
  return "<td class=\"n heat\" style=\"--heat:" + fixed(std::sqrt(share), 2) + "\">" +
         grouped(work) + "</td>";
}

std::string work_matrix(const Subjects& subjects, const std::vector<QueriedPair>& pairs) {
  const std::uint64_t most = std::max<std::uint64_t>(costliest(pairs).costs.needed.most, 1);
  Cells names;
  for (const Subject* const subject : subjects) {
    names.push_back(escaped(subject->name));
  }
  return matrix(
      "", "Most work of each pair at its poses", names, [&](std::size_t i, std::size_t j) {
        const QueriedPair* const pair = find(pairs, subjects[i], subjects[j]);
        return j <= i ? "<td></td>"
                      : matrix_cell(pair != nullptr ? pair : find(pairs, subjects[j], subjects[i]),
                                    most);
      });
}

/// The work of some of the poses.
struct Row {
  const char* name;
  std::vector<std::uint64_t> work;
};

std::array<Row, 5> rows_of(const QueriedPair& pair) {
  std::array<Row, 5> rows = {{{"boxes of the meshes disjoint", {}},
                              {"boxes overlap, none of two leaves", {}},
                              {"leaves overlap, no triangles intersect", {}},
                              {"intersecting: every pair of triangles", {}},
                              {"intersecting: the first pair", {}}}};
  for (const PoseCost& pose : pair.costs.poses) {
    rows[pose.closeness].work.push_back(pose.work);
    if (pose.closeness == kIntersecting) {
      rows[kClosenessCount].work.push_back(pose.work_to_first);
    }
  }
  return rows;
}

Cells cells_of(const Row& row, std::uint64_t most) {
  if (row.work.empty()) {
    return {row.name, "0", "&ndash;", "&ndash;", ""};
  }
  const NeededWork work = needed_work(row.work);
  const auto width = [&](double part) {
    return fixed(100 * part / static_cast<double>(most), 1) + "%\"></span>";
  };
  return {row.name, grouped(row.work.size()),
          grouped(static_cast<std::uint64_t>(std::llround(work.mean))), grouped(work.most),
          "<div class=\"row over\"><span class=inner style=\"width:" +
              width(static_cast<double>(work.most)) +
              "<span class=leaf style=\"width:" + width(work.mean) + "</div>"};
}

std::string closeness_table(const QueriedPair& pair) {
  std::vector<Cells> cells;
  for (const Row& row : rows_of(pair)) {
    cells.push_back(cells_of(row, std::max<std::uint64_t>(pair.costs.needed.most, 1)));
  }
  return "<div class=hist>\n" +
         table("Work of " + title_of(pair) + ", by how close they come",
               {"the meshes", "#poses", "#" + square("leaf") + "mean",
                "#" + square("inner") + "most", "<span class=hide>bar</span>"},
               cells) +
         "</div>\n";
}

/// The number of pairs of two meshes; a pair and its reverse count once.
std::size_t count_different(const std::vector<QueriedPair>& pairs) {
  std::set<std::pair<std::size_t, std::size_t>> different;
  for (const QueriedPair& pair : pairs) {
    if (pair.a != pair.b) {
      different.insert(std::minmax(pair.a->number, pair.b->number));
    }
  }
  return different.size();
}

/// Reasons why there may be fewer poses than requested.
std::string shortfall(const PairCosts& costs) {
  return (costs.costly ? note("Stopped after " + grouped(kMostVisits) +
                              " visits in all: there are fewer poses.")
                       : "") +
         (costs.out_of_range == 0
              ? ""
              : note(counted(costs.out_of_range, "pose", "poses") +
                     " passed over: a mesh lies so far from its origin that rotating it about its "
                     "middle takes a translation out of range."));
}

}  // namespace

std::string line_of(const Pose& pose, double cell) {
  std::string line;
  const auto numbers = pose_numbers(pose, cell);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    line += (i == 0 ? "" : " ") + (i < 9 ? significant(numbers[i], 10) : shortest(numbers[i]));
  }
  return line;
}

std::string shown_at(const QueriedPair& pair, const Pose& pose) {
  return pair.live ? concat(" data-pair=", *pair.live, " data-values=\"",
                            line_of(pose, pair.a->image.cell()), "\"")
                   : "";
}

std::string pairs_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                          const ReportOptions& options) {
  const std::size_t different = subjects.size() * (subjects.size() - 1) / 2;
  const std::size_t tested = count_different(pairs);
  std::string html;
  if (tested < different) {
    html += note(counted(different - tested, "pair is", "pairs are") + " not tested: " +
                 (options.poses.empty() ? "baked with another cell, layout or index width, or "
                                          "beyond the first few."
                                        : "no poses are given."));
  }
  if (!pairs.empty() && !costliest(pairs).costs.poses.empty()) {
    const QueriedPair& worst = costliest(pairs);
    html += (subjects.size() > 2 ? work_matrix(subjects, pairs) : "") + pose_texts(worst) +
            closeness_table(worst) + poses_table(pairs);
  }
  for (const QueriedPair& pair : pairs) {
    html += shortfall(pair.costs);
  }
  return html.empty() ? "" : section("poses", "Where the work is", html);
}

}  // namespace flashbvh::tool
