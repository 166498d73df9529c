#include "report/standing.hpp"

#include <algorithm>
#include <tuple>

#include "evaluate/queries.hpp"
#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest numbers of listed decisions and poses; the page counts the others.
constexpr std::size_t kMostDecisions = 6;
constexpr std::size_t kMostPoses = 200;

bool touches(const Standing& standing) {
  return standing.pairs != 0 || standing.is_inside.value_or(false);
}

/// True if the surfaces are apart, and no query decided whether a mesh is inside the other.
bool is_undecided(const Standing& standing) {
  return standing.pairs == 0 && !standing.is_inside;
}

const char* colour_of(const Standing& standing) {
  return touches(standing) ? "v3" : is_undecided(standing) ? "v1" : "v0";
}

/// Orders by distance; intersecting meshes come first.
bool is_nearer(const Standing& p, const Standing& q) {
  return std::tuple(q.pairs, touches(q), p.distance) < std::tuple(p.pairs, touches(p), q.distance);
}

const Standing& nearest_of(const QueriedPair& pair) {
  return *std::min_element(pair.standings.begin(), pair.standings.end(), is_nearer);
}

Standing standing_at(const ImageFile& a, const ImageFile& b, const Pose& pose, std::uint64_t pairs,
                     Witness<std::uint32_t>& hint) {
  Standing standing = {pairs, std::nullopt, false, 0};
  if (pairs != 0 || a.layout() != Layout::post_indexed) {
    return standing;
  }
  const ClearanceAnswer found = clearance(a.tree(), b.tree(), pose, hint);
  standing.is_inside = one_is_inside(a, b, pose);
  standing.has_distance = found.status == Status::done;
  standing.distance = found.lower * a.cell() / kFineOne;
  return standing;
}

/// "24 pairs of triangles" or "3.2 mm apart".
std::string text_of(const Standing& standing, const Measure& measure) {
  if (standing.pairs != 0) {
    return counted(standing.pairs, "pair of triangles", "pairs of triangles");
  }
  return standing.has_distance ? length_of(measure, standing.distance) + " apart" : "";
}

/// The verdict as a text: "peg intersects ring".
std::string what_of(const QueriedPair& pair, const Standing& standing) {
  const std::string a = escaped(pair.a->name);
  const std::string b = (pair.a == pair.b ? "A second " : "") + escaped(pair.b->name);
  return standing.pairs != 0      ? b + " intersects " + a
         : touches(standing)      ? "Of " + b + " and " + a + " one lies inside the other"
         : is_undecided(standing) ? b + " and " + a + ": surfaces apart, insides not tested"
                                  : b + " does not touch " + a;
}

std::string decision_of(const QueriedPair& pair) {
  const std::vector<Standing>& all = pair.standings;
  const Standing& nearest = nearest_of(pair);
  const auto touching = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), touches));
  std::string of = text_of(nearest, measure_of(pair.a->image));
  if (!pair.costs.are_given) {
    of += of.empty() ? "as drawn" : ", as drawn";
  } else if (all.size() > 1) {
    const auto place = static_cast<std::size_t>(&nearest - all.data());
    const std::string pose =
        concat("<span", shown_at(pair, pair.costs.poses[place].pose), ">pose ", place, "</span>");
    const std::string poses = counted(all.size(), "pose", "poses");
    of = touching == 0
             ? concat(of, of.empty() ? "at " : ", the nearest of ", poses,
                      of.empty() ? "" : ": " + pose)
             : concat("at ", grouped(touching), " of ", poses, ", most at ", pose, ": ", of);
  }
  return decision(colour_of(nearest), what_of(pair, nearest), of);
}

}  // namespace

std::vector<Standing> standings_of(const ImageFile& a, const ImageFile& b,
                                   const std::vector<PoseCost>& poses) {
  std::vector<Standing> standings;
  standings.reserve(poses.size() + 1);
  Witness<std::uint32_t> hint;
  for (const PoseCost& cost : poses) {
    standings.push_back(standing_at(a, b, cost.pose, cost.triangle_pairs, hint));
  }
  if (poses.empty()) {
    const Pose drawn = Pose::translated(0, 0, 0);
    const Answer answer = collide(a.tree(), b.tree(), drawn, default_traversal(a.layout()), {});
    check_answered(answer, b.path(), 0);
    standings.push_back(standing_at(a, b, drawn, answer.counts.triangle_pairs, hint));
  }
  return standings;
}

std::string standing_decisions(const std::vector<QueriedPair>& pairs) {
  std::vector<const QueriedPair*> order;
  for (const QueriedPair& pair : pairs) {
    if (!pair.standings.empty()) {
      order.push_back(&pair);
    }
  }
  std::stable_sort(order.begin(), order.end(), [](const auto* p, const auto* q) {
    return is_nearer(nearest_of(*p), nearest_of(*q));
  });
  const auto touching = std::count_if(order.begin(), order.end(),
                                      [](const auto* pair) { return touches(nearest_of(*pair)); });
  std::string html = order.size() < 2 ? ""
                                      : decision(touching == 0 ? "v0" : "v3",
                                                 concat(touching == 0 ? "None" : concat(touching),
                                                        " of ", order.size(), " pairs touch"),
                                                 "");
  const std::size_t shown = std::min(order.size(), kMostDecisions);
  for (std::size_t i = 0; i < shown; ++i) {
    html += decision_of(*order[i]);
  }
  return html + (order.size() == shown ? ""
                                       : concat("<li class=soft>and ", order.size() - shown,
                                                " more, less near</li>\n"));
}

std::string poses_table(const std::vector<QueriedPair>& pairs) {
  std::vector<Cells> rows;
  std::size_t all = 0;
  for (const QueriedPair& pair : pairs) {
    const std::size_t count = pair.costs.are_given ? pair.standings.size() : 0;
    all += count;
    for (std::size_t i = 0; i < count && rows.size() < kMostPoses; ++i) {
      const PoseCost& cost = pair.costs.poses[i];
      rows.push_back({concat("<span", shown_at(pair, cost.pose), ">", i, "</span>"),
                      square(colour_of(pair.standings[i])) + what_of(pair, pair.standings[i]),
                      text_of(pair.standings[i], measure_of(pair.a->image)), grouped(cost.work)});
    }
  }
  return rows.empty() ? ""
                      : table("Poses", {"pose", "verdict", "how far", "#work"}, rows) +
                            (all == rows.size()
                                 ? ""
                                 : note(concat("And ", grouped(all - rows.size()), " more.")));
}

std::string verdicts_of(const std::vector<Standing>& standings) {
  std::string verdicts;
  for (const Standing& standing : standings) {
    verdicts += touches(standing) ? '3' : '0';
  }
  return verdicts;
}

}  // namespace flashbvh::tool
