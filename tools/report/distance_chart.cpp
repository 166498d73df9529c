#include "report/distance_chart.hpp"

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
constexpr double kPlotLeft = 70;    // of the plot, for lengths
constexpr double kBelowPlot = 60;   // for the verdicts and the lines' numbers
constexpr double kPlotRight = 985;  // the plot's end
constexpr double kStripHeight = 12;
/// So many times the warn distance is shown.
constexpr double kShownFold = 5;

/// At least `length`, and 1, 2 or 5 times a power of ten.
double round_length(double length) {
  const double power = std::pow(10, std::floor(std::log10(length)));
  const double digit = length / power;
  return power * (digit < 1.001 ? 1 : digit < 2.001 ? 2 : digit < 5.001 ? 5 : 10);
}

/// What the chart's height is, in metres.
double top_of(const DistanceChart& chart) {
  double most = 0;
  for (const DistanceLine& line : chart.lines) {
    for (const std::optional<double>& metres : line.metres) {
      most = std::max(most, metres.value_or(0));
    }
  }
  const double shown = chart.warn > 0 ? std::min(most, kShownFold * chart.warn) : most;
  return shown > 0 ? round_length(std::max(shown, chart.warn)) : 1;
}

std::string at(double x, double y) {
  return fixed(x, 1) + " " + fixed(y, 1);
}

double height_of(double metres, double top) {
  return kChartHeight * (1 - std::min(metres / top, 1.0));
}

std::string path_of(const DistanceLine& line, double top) {
  std::string path;
  bool is_drawing = false;
  const double last = std::max<double>(static_cast<double>(line.metres.size()) - 1, 1);
  for (std::size_t i = 0; i < line.metres.size(); ++i) {
    const std::optional<double>& metres = line.metres[i];
    if (metres) {
      path += (is_drawing ? "L" : "M") +
              at(kPlotLeft + (kPlotRight - kPlotLeft) * static_cast<double>(i) / last,
                 height_of(*metres, top));
    }
    is_drawing = metres.has_value();
  }
  return path;
}

std::string text(double x, double y, const char* anchor, const std::string& content) {
  return concat("<text x=", fixed(x, 0), " y=", fixed(y, 0), " style=\"text-anchor:", anchor, "\">",
                content, "</text>\n");
}

/// A line across at a length.
std::string level(double metres, double top, const char* name) {
  const double y = height_of(metres, top);
  return concat("<path class=", name, " d=\"M", at(kPlotLeft, y), "H", fixed(kPlotRight, 1),
                "\"/>\n");
}

std::string strip(const DistanceChart& chart) {
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

std::string key_of(const DistanceChart& chart) {
  std::string html = "<p class=keys>";
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    html += concat("<i class=\"key c", i, "\"></i>", escaped(chart.lines[i].name), " ");
  }
  for (const std::size_t kind : kKindsInOrder) {
    html += concat("<i class=\"key v", kind, "\"></i>", kKindNames[kind], " ");
  }
  return html + "</p>\n";
}

}  // namespace

std::string chart_style() {
  return ".chart text{font-size:26px}\n@media (min-width:760px){.chart text{font-size:15px}}\n"
         ".chart path{stroke-width:1.6px}.chart .stop{stroke:rgb(var(--hot))}\n"
         ".chart .warn{stroke:var(--bad)}.stop,.warn{stroke-dasharray:7 5}\n"
         ".v0{background:var(--line);fill:var(--line)}.v1{background:var(--bad);fill:var(--bad)}\n"
         ".v2{background:var(--k3);fill:var(--k3)}\n"
         ".v3{background:rgb(var(--hot));fill:rgb(var(--hot))}\n"
         ".v4{background:var(--text);fill:var(--text)}\n"
         ".c0{background:var(--k0)}.c1{background:var(--k1)}.c2{background:var(--k2)}\n"
         ".c3{background:var(--k3)}\n";
}

std::string drawn(const DistanceChart& chart) {
  const double top = top_of(chart);
  std::string svg =
      concat("<figure class=chart><svg viewBox=\"0 -14 ", fixed(kChartWidth, 0), " ",
             fixed(kChartHeight + kBelowPlot + 14, 0),
             "\" role=img aria-label=\"Distances over time\">\n<path class=axis d=\"M",
             at(kPlotLeft, 0), "V", fixed(kChartHeight, 0), "H", fixed(kPlotRight, 0), "\"/>\n");
  svg += text(kPlotLeft - 8, 4, "end", significant(top, 3) + " m") +
         text(kPlotLeft - 8, kChartHeight, "end", "0") + level(chart.stop, top, "stop") +
         level(chart.warn, top, "warn");
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    svg += concat("<path class=k", i, " d=\"", path_of(chart.lines[i], top), "\"/>\n");
  }
  const double y = kChartHeight + 8 + kStripHeight + 20;
  svg += strip(chart) + text(kPlotLeft, y, "start", chart.first) +
         text(kPlotRight, y, "end", chart.last);
  return key_of(chart) + svg +
         "</svg><figcaption>Distance of the meshes in each period; dashed: the stop and the warn "
         "distance. Below: what the guard says. What is far above is cut "
         "off.</figcaption></figure>\n";
}

}  // namespace flashbvh::tool
