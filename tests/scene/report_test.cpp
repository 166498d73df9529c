// Figures that the tables print.
#include <catch2/catch.hpp>

#include "evaluate/run.hpp"

using namespace flashbvh;
using tool::Leaves;

namespace {

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
