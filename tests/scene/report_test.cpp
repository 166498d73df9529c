// Figures that the tables print.
#include <catch2/catch.hpp>

#include "evaluate/figure.hpp"
#include "evaluate/run.hpp"
#include "evaluate/tables.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace {

tool::SetupResult result_of(std::uint32_t volume, std::uint32_t ranked) {
  const Counts first = {volume, 1, 2, 3};
  const Counts second = {ranked, 1, 2, 3};
  return {&scene::kSetups[0],
          1,
          1,
          {{"volume-stack", first, {}},
           {"stackless", first, {}},
           {"leaf", first, {}},
           {"ranked", second, {}}},
          std::nullopt,
          {{"ranked", second, {}}}};
}

}  // namespace

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

TEST_CASE("the summary adds up, and finds the worst setup") {
  const tool::Totals totals = tool::totals_of({result_of(100, 90), result_of(10, 12)});
  CHECK(totals.volume == 110);
  CHECK(totals.ranked == 102);
  CHECK(totals.worst_ranked == 1.2);
  CHECK(totals.best == 0);
}

TEST_CASE("tables are aligned Markdown") {
  CHECK(tool::markdown_table({{"name", "n"}, {"a", "10"}, {"long name", "5"}}) ==
        "| name      |  n |\n"
        "| --------- | -: |\n"
        "| a         | 10 |\n"
        "| long name |  5 |\n");
}

TEST_CASE("the figure has a line of every algorithm, by its name, and every number of faces") {
  std::vector<tool::SetupResult> results;
  for (const scene::Setup& setup : scene::kSetups) {
    if (setup.table == tool::kScalabilityTable) {
      results.push_back(result_of(100, 90));
      results.back().setup = &setup;
      for (tool::RowResult& row : results.back().rows) {
        row.times = tool::times_of({0.5, 1.5});
      }
    }
  }
  const std::string figure = tool::figure_33(results);
  for (const char* name : {"volume-stack", "ranked", "Iterations", "Time", "796", "203776"}) {
    CAPTURE(name);
    CHECK(figure.find(std::string(">") + name + "</text>") != std::string::npos);
  }
  CHECK(figure.find("</svg>") != std::string::npos);
}
