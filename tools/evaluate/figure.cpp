#include "evaluate/figure.hpp"

#include <algorithm>
#include <cmath>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct ChartPoint {
  double x;
  double y;
};

/// A line of the chart; `style` is the number of its colour, marker and dashes, 0 to 7.
struct Series {
  int style;
  std::vector<ChartPoint> points;  ///< all positive
};

struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<double> x_ticks;
  std::vector<Series> series;
};

/// Where a chart's plotting area lies in the drawing.
struct Frame {
  double left;
  double top;
  double width;
  double height;
};

std::string at(double value) {
  return fixed(value, 1);
}

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + at(value) + "\"";
}

std::string text_at(double x, double y, const char* style, const std::string& text) {
  return "<text" + attribute("x", x) + attribute("y", y) + " class=\"" + style + "\">" + text +
         "</text>\n";
}

std::string line_from(ChartPoint p, ChartPoint q, const char* style) {
  return "<line" + attribute("x1", p.x) + attribute("y1", p.y) + attribute("x2", q.x) +
         attribute("y2", q.y) + " class=\"" + style + "\"/>\n";
}

/// Eight shapes: a circle, a square, a diamond, a triangle; then the same hollow.
std::string marker(int style, ChartPoint p) {
  const std::string kind = concat(" class=\"", style < 4 ? "full" : "hollow", " s", style, "\"");
  const double r = style < 4 ? 4 : 5.5;
  const auto polygon = [&](std::initializer_list<ChartPoint> corners) {
    std::string points;
    for (const ChartPoint& corner : corners) {
      points += at(p.x + corner.x * r) + "," + at(p.y + corner.y * r) + " ";
    }
    return "<polygon points=\"" + points + "\"" + kind + "/>\n";
  };
  switch (style % 4) {
    case 0:
      return "<circle" + attribute("cx", p.x) + attribute("cy", p.y) + attribute("r", r) + kind +
             "/>\n";
    case 1:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
    default:
      return polygon({{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}});
  }
}

std::string power_of_ten(int exponent) {
  return exponent >= 0 && exponent <= 6
             ? std::to_string(static_cast<long>(std::lround(std::pow(10.0, exponent))))
             : concat("10<tspan dy=\"-5\" font-size=\"9\">", exponent, "</tspan>");
}

/// Maps values to the drawing.
class Scale {
 public:
  Scale(const Chart& chart, const Frame& frame) : frame_(frame) {
    x_low_ = std::log10(chart.x_ticks.front()) - 0.12;
    x_high_ = std::log10(chart.x_ticks.back()) + 0.12;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Series& series : chart.series) {
      for (const ChartPoint& point : series.points) {
        low = std::min(low, std::log10(point.y));
        high = std::max(high, std::log10(point.y));
      }
    }
    y_low_ = static_cast<int>(std::floor(low));
    y_high_ = std::max(y_low_ + 1, static_cast<int>(std::ceil(high)));
  }

  int y_low() const { return y_low_; }
  int y_high() const { return y_high_; }
  double x(double value) const {
    return frame_.left + frame_.width * (std::log10(value) - x_low_) / (x_high_ - x_low_);
  }
  double y_of_log(double log) const {
    return frame_.top + frame_.height * (y_high_ - log) / (y_high_ - y_low_);
  }
  ChartPoint place(const ChartPoint& point) const {
    return {x(point.x), y_of_log(std::log10(point.y))};
  }

 private:
  Frame frame_;
  double x_low_;
  double x_high_;
  int y_low_;
  int y_high_;
};

std::string draw_axes(const Chart& chart, const Frame& frame, const Scale& scale) {
  const double right = frame.left + frame.width;
  const double bottom = frame.top + frame.height;
  std::string svg;
  for (int exponent = scale.y_low(); exponent <= scale.y_high(); ++exponent) {
    const double y = scale.y_of_log(exponent);
    svg += line_from({frame.left, y}, {right, y}, "grid");
    svg += text_at(frame.left - 8, y + 4, "text end", power_of_ten(exponent));
  }
  for (const double tick : chart.x_ticks) {
    svg += line_from({scale.x(tick), bottom}, {scale.x(tick), bottom + 5}, "axis");
    svg += text_at(scale.x(tick), bottom + 20, "text middle", fixed(tick, 0));
  }
  svg += line_from({frame.left, bottom}, {right, bottom}, "axis");
  svg += line_from({frame.left, frame.top}, {frame.left, bottom}, "axis");
  svg += text_at(frame.left + frame.width / 2, bottom + 42, "text middle", chart.x_label);
  svg += text_at(frame.left - 50, frame.top - 34, "text title", chart.title);
  svg += text_at(frame.left - 50, frame.top - 14, "text", chart.y_label);
  return svg;
}

std::string draw_series(const Series& series, const Scale& scale) {
  std::string points;
  std::string markers;
  for (const ChartPoint& point : series.points) {
    const ChartPoint p = scale.place(point);
    points += at(p.x) + "," + at(p.y) + " ";
    markers += marker(series.style, p);
  }
  return concat("<polyline points=\"", points, "\" class=\"line s", series.style, "\"/>\n",
                markers);
}

/// The chart's elements. The y axis covers whole powers of ten.
std::string draw(const Chart& chart, const Frame& frame) {
  const Scale scale(chart, frame);
  std::string svg = draw_axes(chart, frame, scale);
  for (const Series& series : chart.series) {
    svg += draw_series(series, scale);
  }
  return svg;
}

/// A short piece of a series' line with its marker and its name after it.
std::string draw_legend_entry(int style, const std::string& name, double x, double y) {
  return concat("<polyline points=\"", at(x), ",", at(y), " ", at(x + 30), ",", at(y),
                "\" class=\"line s", style, "\"/>\n", marker(style, {x + 15, y}),
                text_at(x + 38, y + 4, "text", name));
}

/// Opens the drawing: size, styles for light and dark surroundings.
std::string svg_head(int width, int height, const std::string& title) {
  const std::string size = concat(width, " ", height);
  return concat("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ", size, "\" width=\"",
                width, "\" height=\"", height,
                "\" role=\"img\" font-family=\"sans-serif\" font-size=\"12\">\n<title>", title,
                "</title>\n", R"(<style>
.paper{fill:#fff}.text{fill:#24292f}.title{font-size:15px;font-weight:bold}
.end{text-anchor:end}.middle{text-anchor:middle}.axis{stroke:#57606a}.grid{stroke:#d8dee4}
.line{fill:none;stroke-width:1.8}.full{stroke:none}.hollow{fill:none!important;stroke-width:1.6}
.s0{stroke:#1f5fbf}.full.s0{fill:#1f5fbf}.s1{stroke:#a8431b}.full.s1{fill:#a8431b}
.s2{stroke:#8a6a00}.full.s2{fill:#8a6a00}.s3{stroke:#6b7280}.full.s3{fill:#6b7280}
.s4{stroke:#0a7d4f}.s5{stroke:#8b3fb5}.s6{stroke:#c2277a}.s7{stroke:#24292f}
.line.s1,.line.s5{stroke-dasharray:7 4}.line.s2,.line.s6{stroke-dasharray:2 4}
.line.s7{stroke-dasharray:1 5}
@media (prefers-color-scheme:dark){
.paper{fill:#0d1117}.text{fill:#e6edf3}.axis{stroke:#9198a1}.grid{stroke:#30363d}
.s0{stroke:#6ea8fe}.full.s0{fill:#6ea8fe}.s1{stroke:#f0883e}.full.s1{fill:#f0883e}
.s2{stroke:#e3b341}.full.s2{fill:#e3b341}.s3{stroke:#9da5b0}.full.s3{fill:#9da5b0}
.s4{stroke:#4ac78a}.s5{stroke:#c89bf0}.s6{stroke:#ff7eb6}.s7{stroke:#e6edf3}}
</style>
<rect width="100%" height="100%" class="paper"/>
)");
}

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
  add(concat("best rule (up to ", kBestRuleFaces, ")"));
  return svg;
}

}  // namespace

std::string figure_33(const std::vector<SetupResult>& results) {
  const Results chosen = of_table(results);
  return svg_head(kWidth, kHeight, "Scalability: iterations and time over faces") +
         draw(iterations_of(chosen), kLeft) + draw(times_of_rows(chosen), kRight) + legend(chosen) +
         "</svg>\n";
}

}  // namespace flashbvh::tool
