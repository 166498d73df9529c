#include "report/chart.hpp"

#include <algorithm>
#include <cmath>

#include "report/html.hpp"
#include "robot/replay/replay.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// The drawing, in units of its own.
constexpr double kChartWidth = 1000;
constexpr double kChartHeight = 300;
constexpr double kPlotLeft = 120;   // of the plot, for lengths
constexpr double kPlotRight = 985;  // the plot's end
constexpr double kLane = 30;        // of a verdict, below the plot
constexpr double kBar = 18;         // in it
constexpr double kBelowLanes = 48;  // for the first and the last line's numbers
constexpr double kLeastBar = 3;     // a single period can be seen
/// Of line styles that have a number; the one behind them is dotted.
constexpr std::size_t kNumbered = 6;

/// Of the kinds of periods.
constexpr const char* kLetters[kPeriodKinds] = {"F", "W", "N", "S", "R"};

/// At least `value`, and 1, 2 or 5 times a power of ten.
double round_number(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit < 1.001 ? 1 : digit < 2.001 ? 2 : digit < 5.001 ? 5 : 10);
}

/// What the chart's height is.
double top_of(const Chart& chart) {
  double shown = 0;
  for (const DistanceTableLine& line : chart.lines) {
    for (const std::optional<double>& value : line.values) {
      shown = std::max(shown, value.value_or(0));
    }
  }
  shown = chart.most > 0 ? std::min(shown, chart.most) : shown;
  for (const DistanceTableLevel& level : chart.levels) {
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

/// `part`: 0 at the left end of the plot, 1 at the right one.
double x_of(double part) {
  return kPlotLeft + (kPlotRight - kPlotLeft) * part;
}

/// Of a line's value.
double x_of(const DistanceTableLine& line, std::size_t place) {
  return x_of(static_cast<double>(place) /
              std::max<double>(static_cast<double>(line.values.size()) - 1, 1));
}

std::string path_of(const DistanceTableLine& line, double top) {
  std::string path;
  bool is_drawing = false;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    const std::optional<double>& value = line.values[i];
    if (value) {
      path += (is_drawing ? "L" : "M") + at(x_of(line, i), height_of(*value, top));
    }
    is_drawing = value.has_value();
  }
  return path;
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return concat("<text x=", fixed(x, 0), " y=", fixed(y, 0), " style=\"text-anchor:", anchor, "\">",
                content, "</text>\n");
}

/// `order`: of the levels, whose names stand side by side.
std::string level_line(const DistanceTableLevel& level, double top, std::size_t order) {
  const double y = height_of(level.value, top);
  return concat("<path class=", level.style, " d=\"M", at(kPlotLeft, y), "H", fixed(kPlotRight, 1),
                "\"/>\n") +
         text(kPlotRight - 110 * static_cast<double>(order), y - 12, "end", level.name);
}

/// The line's number, on the line; lines have theirs side by side.
std::string number_on(const DistanceTableLine& line, std::size_t lines, double top) {
  const std::size_t count = line.values.size();
  std::size_t place = std::min((2 * line.style + 1) * count / (2 * lines), count - 1);
  while (place < count && !line.values[place]) {
    ++place;
  }
  if (place == count) {
    return "";
  }
  return concat("<text class=number x=", fixed(x_of(line, place), 0),
                " y=", fixed(height_of(*line.values[place], top), 0), ">", line.style + 1,
                "</text>\n");
}

bool has_numbers(const Chart& chart) {
  return chart.lines.size() > 1;
}

/// The periods of a kind, in a lane below the plot; nothing if there are none.
std::string lane(const Chart& chart, std::size_t kind, double y) {
  std::string svg;
  for (const KindRun& run : chart.runs) {
    if (run.kind == kind) {
      svg += concat("<rect class=v", kind, " x=", fixed(x_of(run.begin), 1), " y=", fixed(y, 0),
                    " width=", fixed(std::max(x_of(run.end) - x_of(run.begin), kLeastBar), 2),
                    " height=", fixed(kBar, 0), "></rect>\n");
    }
  }
  return svg.empty() ? "" : text(kPlotLeft - 8, y + kBar / 2, "end", kLetters[kind]) + svg;
}

std::string line_key(const DistanceTableLine& line, bool is_numbered) {
  return concat("<span><svg class=sample viewBox=\"0 0 40 8\"><path class=l", line.style,
                " d=\"M0 4H40\"/></svg>",
                is_numbered && line.style < kNumbered ? concat(line.style + 1, " ") : "", line.name,
                "</span>\n");
}

std::string keys_of(const Chart& chart) {
  std::string html = "<p class=keys>";
  for (const DistanceTableLine& line : chart.lines) {
    html += line_key(line, has_numbers(chart));
  }
  if (!chart.runs.empty()) {
    html += "</p>\n<p class=keys><span>What the guard says:</span>\n";
    for (const std::size_t kind : kKindsInOrder) {
      html += key(concat("v", kind), concat(kLetters[kind], " ", kKindNames[kind]));
    }
  }
  return html + "</p>\n";
}

}  // namespace

std::string drawn(const Chart& chart) {
  const double top = top_of(chart);
  std::string plot =
      text(kPlotLeft - 8, 4, "end", (top < 1 ? significant(top, 3) : fixed(top, 0)) + chart.unit) +
      text(kPlotLeft - 8, kChartHeight, "end", "0");
  for (std::size_t i = 0; i < chart.levels.size(); ++i) {
    plot += level_line(chart.levels[i], top, i);
  }
  for (const DistanceTableLine& line : chart.lines) {
    plot += concat("<path class=l", line.style, " d=\"", path_of(line, top), "\"/>\n");
  }
  for (const DistanceTableLine& line : chart.lines) {
    plot += has_numbers(chart) && line.style < kNumbered
                ? number_on(line, chart.lines.size() - 1, top)
                : "";
  }
  double y = kChartHeight + 10;
  for (const std::size_t kind : kKindsInOrder) {
    const std::string bars = lane(chart, kind, y);
    plot += bars;
    y += bars.empty() ? 0 : kLane;
  }
  plot += text(kPlotLeft, y + kBelowLanes / 2, "start", chart.first) +
          text(kPlotRight, y + kBelowLanes / 2, "end", chart.last);
  return keys_of(chart) +
         concat("<figure class=chart><svg viewBox=\"0 -14 ", fixed(kChartWidth, 0), " ",
                fixed(y + kBelowLanes + 14, 0), "\" role=img aria-label=\"", chart.label,
                "\">\n<path class=axis d=\"M", at(kPlotLeft, 0), "V", fixed(kChartHeight, 0), "H",
                fixed(kPlotRight, 0), "\"/>\n") +
         plot + "</svg><figcaption>" + chart.caption + "</figcaption></figure>\n";
}

}  // namespace flashbvh::tool
