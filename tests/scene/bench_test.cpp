// The results of `flashbvh bench` for the setups: visits over the paper's up to 50,944 faces, with
// FLASHBVH_THOROUGH over all, up to 203,776; the best rule against all rules; tables.
#include <map>

#include "evaluate/run.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;
using bake::BuildTree;
using tool::Leaves;

namespace {

/// The counts alone. Building the trees takes nearly all of these tests' time.
const std::vector<tool::SetupResult>& results() {
  static tool::Objects objects;
  static const std::vector<tool::SetupResult> all = [] {
    const std::uint32_t most = test::is_thorough() ? 203776 : 50944;
    std::vector<tool::SetupResult> chosen;
    for (const scene::Setup& setup : scene::kSetups) {
      if (setup.a.faces() <= most && setup.b.faces() <= most) {
        chosen.push_back(run_setup(setup, {1e-9, 0}, objects));
      }
    }
    return chosen;
  }();
  return all;
}

const QueryStats& counts_of(const tool::SetupResult& result, const char* row) {
  return result.row(row)->counts;
}

using NodePair = std::pair<std::uint32_t, std::uint32_t>;
/// For each pair of inner nodes, whether to descend into A.
using Rule = std::map<NodePair, bool>;

bool overlap(const Box& p, const Box& q) {
  return p.upper.x >= q.lower.x && q.upper.x >= p.lower.x && p.upper.y >= q.lower.y &&
         q.upper.y >= p.lower.y && p.upper.z >= q.lower.z && q.upper.z >= p.lower.z;
}

/// The visits of algorithm 2's walk with this rule.
std::uint64_t visits_of(const BuildTree& a, const BuildTree& b, const Rule& rule) {
  std::vector<NodePair> stack = {{0, 0}};
  std::uint64_t visits = 0;
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    ++visits;
    const auto& node_a = a.nodes[i];
    const auto& node_b = b.nodes[j];
    if (!overlap(node_a.box, node_b.box)) {
      continue;
    }
    if (!node_a.is_leaf() && (node_b.is_leaf() || rule.at({i, j}))) {
      for (const std::uint32_t child : node_a.children) {
        stack.emplace_back(child, j);
      }
    } else {
      for (const std::uint32_t child : node_b.children) {
        stack.emplace_back(i, child);
      }
    }
  }
  return visits;
}

/// All pairs for which a rule must choose.
std::vector<NodePair> choices(const BuildTree& a, const BuildTree& b) {
  std::vector<NodePair> pairs;
  for (std::uint32_t i = 0; i < a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < b.nodes.size(); ++j) {
      if (!a.nodes[i].is_leaf() && !b.nodes[j].is_leaf() &&
          overlap(a.nodes[i].box, b.nodes[j].box)) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return pairs;
}

std::uint64_t fewest_of_all_rules(const BuildTree& a, const BuildTree& b,
                                  const std::vector<NodePair>& pairs) {
  std::uint64_t fewest = UINT64_MAX;
  for (std::uint32_t bits = 0; bits < 1u << pairs.size(); ++bits) {
    Rule rule;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      rule[pairs[i]] = (bits >> i & 1u) != 0;
    }
    fewest = std::min(fewest, visits_of(a, b, rule));
  }
  return fewest;
}

tool::SetupResult result_of(std::uint32_t volume, std::uint32_t ranked) {
  const QueryStats first = {volume, 1, 2, 3};
  const QueryStats second = {ranked, 1, 2, 3};
  const auto row = [](const char* name, const QueryStats& counts) {
    return tool::Row{name, Leaves::boxes, counts, {5e-6, 2e-6}, {}};
  };
  return {&scene::kSetups[0],
          2,
          {row("volume-stack", first),
           row("stackless", first),
           row("leaf", first),
           row("ranked", second),
           row("ranked, default tree", second),
           {"best rule, default tree", Leaves::none, first, {}, {}}}};
}

bool has_line(const std::string& text, const std::string& line) {
  return text.find("\n" + line + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("all rows of every setup find the same overlaps") {
  for (const tool::SetupResult& result : results()) {
    CAPTURE(result.setup->name);
    CHECK(result.rows_agree());
  }
}

TEST_CASE("ranked visits no more than volume-stack in total and 1.03 times as many in any setup") {
  std::uint64_t ranked_total = 0;
  std::uint64_t volume_total = 0;
  for (const tool::SetupResult& result : results()) {
    const std::uint64_t ranked = counts_of(result, "ranked").visits;
    const std::uint64_t volume = counts_of(result, "volume-stack").visits;
    CAPTURE(result.setup->name, ranked, volume);
    CHECK(100 * ranked <= 103 * volume);
    ranked_total += ranked;
    volume_total += volume;
  }
  CAPTURE(ranked_total, volume_total);
  CHECK(ranked_total <= volume_total);
}

TEST_CASE("ranked on the default tree: 0.60 of the paper's visits, 1.10 of the best rule's") {
  std::uint64_t all_ranked = 0, all_best = 0, ranked_intersecting = 0, stackless_intersecting = 0;
  for (const tool::SetupResult& result : results()) {
    const std::uint64_t stackless = counts_of(result, "stackless").visits;
    const std::uint64_t ranked = counts_of(result, "ranked, default tree").visits;
    const std::uint64_t best = counts_of(result, "best rule, default tree").visits;
    CAPTURE(result.setup->name, stackless, ranked, best);
    CHECK(ranked <= stackless);
    CHECK(best <= ranked);
    CHECK(100 * ranked <= 120 * best);
    const bool intersects = counts_of(result, "stackless").triangle_pairs != 0;
    ranked_intersecting += intersects ? ranked : 0;
    stackless_intersecting += intersects ? stackless : 0;
    all_ranked += ranked;
    all_best += best;
  }
  CAPTURE(stackless_intersecting, ranked_intersecting, all_ranked, all_best);
  CHECK(100 * ranked_intersecting <= 60 * stackless_intersecting);
  if (test::is_thorough()) {  // the promise covers all setups together
    CHECK(100 * all_ranked <= 110 * all_best);
  }
}

TEST_CASE("the large setups intersect") {
  for (const tool::SetupResult& result : results()) {
    if (result.setup->a.faces() > 12736 && result.setup->table == 6) {
      CHECK(counts_of(result, "volume-stack").triangle_pairs > 500);
    }
  }
}

TEST_CASE("the best rule needs as many visits as the best of all rules, tried one by one") {
  test::Random random(33);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const auto mesh_a = test::random_mesh(random, 1 + random.below(6), 60, 40);
    const auto mesh_b = test::random_mesh(random, 1 + random.below(6), 60, 40);
    const BuildTree a = test::any_tree(random, mesh_a);
    const BuildTree b = test::any_tree(random, mesh_b);
    const auto pairs = choices(a, b);
    if (pairs.size() <= 10) {
      CHECK(tool::best_rule_visits(a, b, {0, 0, 0}) == fewest_of_all_rules(a, b, pairs));
      compared += pairs.size() >= 2 ? 1 : 0;
    }
  }
  CHECK(compared >= 50);
}

TEST_CASE("the best rule translates B") {
  test::Random random(34);
  const auto mesh = test::random_mesh(random, 40, 300, 100);
  const BuildTree tree = bake::build_median(mesh, 1);
  CHECK(tool::best_rule_visits(tree, tree, {0, 0, 0}) > 1);
  CHECK(tool::best_rule_visits(tree, tree, {2000, 0, 0}) == 1);
  CHECK(tool::best_rule_visits(tree, tree, {0, 0, -2000}) == 1);
}

TEST_CASE("times: least, most, mean and standard deviation of the samples") {
  const tool::Times times = tool::times_of({2, 4, 4, 4, 5, 5, 7, 9});
  CHECK(times.least == 2);
  CHECK(times.most == 9);
  CHECK(times.mean == 5);
  CHECK(times.deviation == 2);
}

TEST_CASE("rows that find different overlaps are noticed") {
  tool::SetupResult result = result_of(10, 10);
  CHECK(result.rows_agree());
  result.rows[3].counts.triangle_pairs = 4;
  CHECK_FALSE(result.rows_agree());
  result = result_of(10, 10);
  result.rows[1].counts.leaf_pairs = 0;
  CHECK_FALSE(result.rows_agree());
  CHECK_FALSE(result_of(10, 0).rows_agree());  // the query was refused
}

TEST_CASE("the summary adds up, finds the worst setup and divides by the repetitions") {
  std::vector<tool::SetupResult> results = {result_of(100, 90), result_of(10, 12)};
  results[1].rows.push_back({"best rule", Leaves::none, {8, 0, 0, 0}, {}, {}});
  const std::string text = tool::summary_tables(results);
  CAPTURE(text);
  CHECK(has_line(text,
                 "| total                              |          110 |       110 |  110 |    "
                 "102 |         - |             1.0000 |          0.9273 |             - |"));
  CHECK(has_line(text,
                 "| total where the best rule is known |           10 |        10 |   10 |     "
                 "12 |         8 |             1.0000 |          1.2000 |        0.8000 |"));
  CHECK(has_line(text, "Largest ranked / volume of a setup: 1.2000"));
  CHECK(has_line(text,
                 "| Intersection test 1 |        1.000 |     1.000 | 1.000 |  1.000 |         "
                 "       1.000 |"));
}

TEST_CASE("tables are aligned Markdown") {
  CHECK(tool::markdown_table({{"name", "n"}, {"a", "10"}, {"long name", "5"}}) ==
        "| name      |  n |\n"
        "| --------- | -: |\n"
        "| a         | 10 |\n"
        "| long name |  5 |\n");
}
