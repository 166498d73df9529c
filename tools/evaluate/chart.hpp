// A chart with logarithmic axes, as SVG.
#ifndef FLASHBVH_TOOLS_EVALUATE_CHART_HPP
#define FLASHBVH_TOOLS_EVALUATE_CHART_HPP

#include <string>
#include <vector>

namespace flashbvh::bench {

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

/// The chart's elements. The y axis covers whole powers of ten.
std::string draw(const Chart& chart, const Frame& frame);

/// A short piece of a series' line with its marker and its name behind it, for a legend.
std::string draw_legend_entry(int style, const std::string& name, double x, double y);

/// Opens the drawing: size, styles for light and dark surroundings. `</svg>` closes it.
std::string svg_head(int width, int height, const std::string& title);

}  // namespace flashbvh::bench

#endif
