#include "report/chart.hpp"

#include <algorithm>
#include <cmath>

#include "report/html.hpp"
#include "robot/replay_summary.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// The drawing, in units of its own.
constexpr double kChartWidth = 1000;
constexpr double kChartHeight = 300;
constexpr double kPlotLeft = 120;   // of the plot, for lengths
constexpr double kBelowPlot = 60;   // for the verdicts and the lines' numbers
constexpr double kPlotRight = 985;  // the plot's end
constexpr double kStripHeight = 12;

/// At least `value`, and 1, 2 or 5 times a power of ten.
double round_number(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit < 1.001 ? 1 : digit < 2.001 ? 2 : digit < 5.001 ? 5 : 10);
}

/// What the chart's height is.
double top_of(const Chart& chart) {
  double shown = 0;
  for (const ChartLine& line : chart.lines) {
    for (const std::optional<double>& value : line.values) {
      shown = std::max(shown, value.value_or(0));
    }
  }
  shown = chart.most > 0 ? std::min(shown, chart.most) : shown;
  for (const ChartLevel& level : chart.levels) {
    shown = std::max(shown, level.value);
  }
  return shown > 0 ? round_number(shown) : 1;
}

std::string at(double x, double y) {
  return fixed(x, 1) + " " + fixed(y, 1);
}

double height_of(double value, double top) {
  return kChartHeight * (1 - std::min(value / top, 1.0));
}

std::string path_of(const ChartLine& line, double top) {
  std::string path;
  bool is_drawing = false;
  const double last = std::max<double>(static_cast<double>(line.values.size()) - 1, 1);
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    const std::optional<double>& value = line.values[i];
    if (value) {
      path += (is_drawing ? "L" : "M") +
              at(kPlotLeft + (kPlotRight - kPlotLeft) * static_cast<double>(i) / last,
                 height_of(*value, top));
    }
    is_drawing = value.has_value();
  }
  return path;
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return concat("<text x=", fixed(x, 0), " y=", fixed(y, 0), " style=\"text-anchor:", anchor, "\">",
                content, "</text>\n");
}

std::string level_line(const ChartLevel& level, double top) {
  return concat("<path class=", level.name, " d=\"M", at(kPlotLeft, height_of(level.value, top)),
                "H", fixed(kPlotRight, 1), "\"/>\n");
}

std::string strip(const Chart& chart) {
  std::string svg;
  for (const KindRun& run : chart.runs) {
    svg += concat("<rect class=v", run.kind,
                  " x=", fixed(kPlotLeft + (kPlotRight - kPlotLeft) * run.begin, 1),
                  " y=", fixed(kChartHeight + 8, 0),
                  " width=", fixed((kPlotRight - kPlotLeft) * (run.end - run.begin), 2),
                  " height=", fixed(kStripHeight, 0), "></rect>\n");
  }
  return svg;
}

std::string keys_of(const Chart& chart) {
  std::string html = "<p class=keys>";
  for (const ChartLine& line : chart.lines) {
    html += key(concat("c", line.colour), line.name);
  }
  if (!chart.runs.empty()) {
    html += "</p>\n<p class=keys><span>What the guard says:</span>\n";
    for (const std::size_t kind : kKindsInOrder) {
      html += key(concat("v", kind), kKindNames[kind]);
    }
  }
  return html + "</p>\n";
}

}  // namespace

std::string chart_style() {
  return ".chart text{font-size:32px}\n@media (min-width:760px){.chart text{font-size:15px}}\n"
         ".chart path{stroke-width:1.6px}.chart .stop{stroke:rgb(var(--hot))}\n"
         ".chart .warn{stroke:var(--bad)}.stop,.warn{stroke-dasharray:7 5}\n"
         ".v0{background:var(--line);fill:var(--line)}.v1{background:var(--bad);fill:var(--bad)}\n"
         ".v2{background:var(--k3);fill:var(--k3)}\n"
         ".v3{background:rgb(var(--hot));fill:rgb(var(--hot))}\n"
         ".v4{background:var(--text);fill:var(--text)}\n"
         ".c0{background:var(--k0)}.c1{background:var(--k1)}.c2{background:var(--k2)}\n"
         ".c3{background:var(--k3)}.c4{background:var(--text)}\n"
         ".chart .k4{stroke:var(--text);stroke-width:1px;stroke-dasharray:2 2}\n";
}

std::string drawn(const Chart& chart) {
  const double top = top_of(chart);
  std::string svg = concat("<figure class=chart><svg viewBox=\"0 -14 ", fixed(kChartWidth, 0), " ",
                           fixed(kChartHeight + kBelowPlot + 14, 0), "\" role=img aria-label=\"",
                           chart.label, "\">\n<path class=axis d=\"M", at(kPlotLeft, 0), "V",
                           fixed(kChartHeight, 0), "H", fixed(kPlotRight, 0), "\"/>\n");
  svg +=
      text(kPlotLeft - 8, 4, "end", (top < 1 ? significant(top, 3) : fixed(top, 0)) + chart.unit) +
      text(kPlotLeft - 8, kChartHeight, "end", "0");
  for (const ChartLevel& level : chart.levels) {
    svg += level_line(level, top);
  }
  for (const ChartLine& line : chart.lines) {
    svg += concat("<path class=k", line.colour, " d=\"", path_of(line, top), "\"/>\n");
  }
  const double y = kChartHeight + 8 + kStripHeight + 20;
  svg += strip(chart) + text(kPlotLeft, y, "start", chart.first) +
         text(kPlotRight, y, "end", chart.last);
  return keys_of(chart) + svg + "</svg><figcaption>" + chart.caption + "</figcaption></figure>\n";
}

}  // namespace flashbvh::tool
