// Distances over time, as a drawing.
#ifndef FLASHBVH_TOOLS_REPORT_DISTANCE_CHART_HPP
#define FLASHBVH_TOOLS_REPORT_DISTANCE_CHART_HPP

#include <optional>
#include <string>
#include <vector>

namespace flashbvh::tool {

struct DistanceLine {
  std::string name;
  std::vector<std::optional<double>> metres;  ///< one a place along the chart; none: not known
};

/// A run of periods of one kind, from `begin` on, as parts of the chart's width; `kind`: of
/// replay_summary.hpp.
struct KindRun {
  double begin;
  double end;
  std::size_t kind;
};

struct DistanceChart {
  std::vector<DistanceLine> lines;  ///< at most four
  std::vector<KindRun> runs;
  double stop;  ///< metres
  double warn;
  std::string first;  ///< below the left and the right end
  std::string last;
};

/// What its colours need.
std::string chart_style();
/// A figure with a key, HTML. Distances far above those that matter are cut off.
std::string drawn(const DistanceChart& chart);

}  // namespace flashbvh::tool

#endif
