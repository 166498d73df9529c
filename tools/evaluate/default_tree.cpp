#include "evaluate/default_tree.hpp"

#include "evaluate/best_rule.hpp"
#include "evaluate/queries.hpp"
#include "evaluate/tables.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::vector<std::string> line_of(const std::string& name, const DefaultTreeVisits& visits) {
  return {name,
          std::to_string(visits.stackless),
          std::to_string(visits.ranked),
          std::to_string(visits.best_rule),
          fixed(visits.ranked_to_stackless(), 4),
          fixed(visits.ranked_to_best(), 4)};
}

}  // namespace

double DefaultTreeVisits::ranked_to_stackless() const {
  return ratio(ranked, stackless);
}

double DefaultTreeVisits::ranked_to_best() const {
  return ratio(ranked, best_rule);
}

DefaultTreeResult compare_default_tree(const scene::Setup& setup, Objects& objects) {
  BakedObject& a = objects.get(setup.a);
  BakedObject& b = objects.get(setup.b);
  const Point& t = setup.translation;
  const Pose pose = Pose::translated(t.x, t.y, t.z);
  const auto stackless =
      collide(a.baked<std::uint32_t>().pre.view(), b.baked<std::uint32_t>().pre.view(), pose,
              default_traversal(Layout::pre_indexed), false);
  const auto ranked = collide(a.baked_default().view(), b.baked_default().view(), pose,
                              default_traversal(Layout::post_indexed), false);
  return {&setup,
          stackless.counts.triangle_pairs != 0,
          {stackless.counts.visits, ranked.counts.visits,
           best_rule_visits(a.default_tree(), b.default_tree(), setup.translation)}};
}

DefaultTreeVisits sum_of(const std::vector<DefaultTreeResult>& results, bool only_intersecting) {
  DefaultTreeVisits sum;
  for (const DefaultTreeResult& result : results) {
    if (result.intersecting || !only_intersecting) {
      sum.stackless += result.visits.stackless;
      sum.ranked += result.visits.ranked;
      sum.best_rule += result.visits.best_rule;
    }
  }
  return sum;
}

std::string default_tree_table(const std::vector<DefaultTreeResult>& results) {
  std::vector<std::vector<std::string>> lines = {{"iterations", "stackless, paper's tree",
                                                  "ranked, default tree", "best rule, default tree",
                                                  "ranked / stackless", "ranked / best"}};
  for (const DefaultTreeResult& result : results) {
    lines.push_back(line_of(result.setup->name, result.visits));
  }
  lines.push_back(line_of("total of the intersecting", sum_of(results, true)));
  lines.push_back(line_of("total", sum_of(results, false)));
  return "### The default tree\n\n" + markdown_table(lines);
}

}  // namespace flashbvh::tool
