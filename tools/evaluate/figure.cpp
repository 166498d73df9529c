#include "evaluate/figure.hpp"

#include "evaluate/chart.hpp"

namespace flashbvh::bench {
namespace {

constexpr int kWidth = 980;
constexpr int kHeight = 520;
constexpr Frame kLeft = {75, 70, 385, 310};
constexpr Frame kRight = {565, 70, 385, 310};

using Results = std::vector<const SetupResult*>;

Results of_table(const std::vector<SetupResult>& results) {
  Results chosen;
  for (const SetupResult& result : results) {
    if (result.setup->table == kScalabilityTable) {
      chosen.push_back(&result);
    }
  }
  return chosen;
}

/// One line: `value(result)` over faces; values of 0 are left out.
template <class Value>
Series series_of(int style, const Results& results, Value&& value) {
  Series series = {style, {}};
  for (const SetupResult* const result : results) {
    if (const double y = value(*result); y > 0) {
      series.points.push_back({static_cast<double>(result->setup->a.faces()), y});
    }
  }
  return series;
}

Chart chart_of(const Results& results, const char* title, const char* y_label) {
  Chart chart = {title, "faces of each object", y_label, {}, {}};
  for (const SetupResult* const result : results) {
    chart.x_ticks.push_back(result->setup->a.faces());
  }
  return chart;
}

Chart iterations_of(const Results& results) {
  Chart chart = chart_of(results, "Iterations", "pairs of boxes tested in one query");
  // Styles by the row's place in the tables, as in the other panel.
  const auto add = [&](int style, const char* algorithm) {
    chart.series.push_back(series_of(style, results, [&](const SetupResult& result) {
      return static_cast<double>(result.row(algorithm).counts.visits);
    }));
  };
  add(0, "volume-stack");
  add(2, "stackless");
  add(4, "leaf");
  add(5, "ranked");
  chart.series.push_back(series_of(7, results, [](const SetupResult& result) {
    return static_cast<double>(result.best_rule.value_or(0));
  }));
  return chart;
}

Chart times_of_rows(const Results& results) {
  Chart chart = chart_of(results, "Time", "milliseconds for one query, fastest sample");
  for (std::size_t i = 0; i < results.front()->rows.size(); ++i) {
    chart.series.push_back(series_of(static_cast<int>(i), results, [i](const SetupResult& result) {
      return 1000 * result.rows[i].times.least / result.repetitions;
    }));
  }
  return chart;
}

std::string legend(const Results& results) {
  constexpr int kColumns = 4;
  constexpr double column = 225;
  std::string svg;
  int style = 0;
  const auto add = [&](const std::string& name) {
    const int row = style / kColumns;
    svg += draw_legend_entry(style, name, 75 + column * (style % kColumns), 458 + 26.0 * row);
    ++style;
  };
  for (const RowResult& row : results.front()->rows) {
    add(row.algorithm);
  }
  add("best rule (up to " + std::to_string(kBestRuleFaces) + ")");
  return svg;
}

}  // namespace

std::string figure_33(const std::vector<SetupResult>& results) {
  const Results chosen = of_table(results);
  return svg_head(kWidth, kHeight, "Scalability: iterations and time over faces") +
         draw(iterations_of(chosen), kLeft) + draw(times_of_rows(chosen), kRight) + legend(chosen) +
         "</svg>\n";
}

}  // namespace flashbvh::bench
