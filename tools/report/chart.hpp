// Numbers over time, as a drawing.
#ifndef FLASHBVH_TOOLS_REPORT_CHART_HPP
#define FLASHBVH_TOOLS_REPORT_CHART_HPP

#include <optional>
#include <string>
#include <vector>

namespace flashbvh::tool {

struct DistanceTableLine {
  std::string name;                           ///< HTML
  std::vector<std::optional<double>> values;  ///< one a place along the chart; none: not known
  std::size_t style = 0;                      ///< 0 to 5: a colour, dashes, a number; 6 is dotted
};

/// A dashed line across; `style`: "stop", "warn".
struct DistanceTableLevel {
  double value;
  const char* style;
  const char* name;
};

/// A run of periods of one kind, from `begin` on, as parts of the chart's width; `kind`: of
/// replay_summary.hpp.
struct KindRun {
  double begin;
  double end;
  std::size_t kind;
};

struct Chart {
  std::string label;  ///< for who can't see it
  std::string unit;   ///< " m"
  std::vector<DistanceTableLine> lines;
  std::vector<DistanceTableLevel> levels;
  double most;                ///< what is above may be cut off; 0: nothing
  std::vector<KindRun> runs;  ///< below the plot; may be none
  std::string first;          ///< below the left and the right end
  std::string last;
  std::string caption;
};

/// A figure with a key, HTML.
std::string drawn(const Chart& chart);

}  // namespace flashbvh::tool

#endif
