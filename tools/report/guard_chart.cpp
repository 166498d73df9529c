#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/guard_page.hpp"
#include "report/html.hpp"
#include "robot/replay/replay.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// A drawing of numbers over time.

struct ChartLine {
  std::string name;                           ///< HTML
  std::vector<std::optional<double>> values;  ///< one per position on the chart; none: not known
  std::size_t style = 0;                      ///< 0 to 5: a colour, dashes, a number; 6: dotted
};

/// A dashed horizontal line; `style`: "stop", "warn".
struct ChartLevel {
  double value;
  const char* style;
  const char* name;
};

/// A run of periods of one kind, `begin` and `end` as parts of the chart's width. `kind`: as in
/// replay.hpp.
struct KindRun {
  double begin;
  double end;
  std::size_t kind;
};

struct Chart {
  std::string label;  ///< for screen readers
  std::string unit;   ///< such as " m"
  std::vector<ChartLine> lines;
  std::vector<ChartLevel> levels;
  double most;                ///< values above it may be cut off; 0: none
  std::vector<KindRun> runs;  ///< below the plot; may be empty
  std::string first;          ///< text below the left end; `last`: below the right end
  std::string last;
  std::string caption;
};

// Dimensions of the drawing, in its own units.
constexpr double kChartWidth = 1000;
constexpr double kChartHeight = 300;
constexpr double kPlotLeft = 120;   // left end of the plot; leaves space for lengths
constexpr double kPlotRight = 985;  // right end of the plot
constexpr double kLane = 30;        // height of a verdict's lane, below the plot
constexpr double kBar = 18;         // height of a bar in a lane
constexpr double kBelowLanes = 48;  // space for the first and the last line's numbers
constexpr double kLeastBar = 3;     // keeps a single period visible
/// The number of line styles with a number; the next style is dotted.
constexpr std::size_t kNumbered = 6;

/// The letters of the kinds of periods.
constexpr const char* kLetters[kPeriodKinds] = {"F", "W", "N", "S", "R"};

/// The smallest number from `value` on that is 1, 2 or 5 times a power of ten.
double round_number(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double digit = value / power;
  return power * (digit < 1.001 ? 1 : digit < 2.001 ? 2 : digit < 5.001 ? 5 : 10);
}

/// The value at the top of the chart.
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

/// `part`: 0 is the left end of the plot, 1 the right end.
double x_of(double part) {
  return kPlotLeft + (kPlotRight - kPlotLeft) * part;
}

/// The position of a line's value.
double x_of(const ChartLine& line, std::size_t place) {
  return x_of(static_cast<double>(place) /
              std::max<double>(static_cast<double>(line.values.size()) - 1, 1));
}

std::string path_of(const ChartLine& line, double top) {
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

/// `order`: of the levels, whose names are side by side.
std::string level_line(const ChartLevel& level, double top, std::size_t order) {
  const double y = height_of(level.value, top);
  return concat("<path class=", level.style, " d=\"M", at(kPlotLeft, y), "H", fixed(kPlotRight, 1),
                "\"/>\n") +
         text(kPlotRight - 110 * static_cast<double>(order), y - 12, "end", level.name);
}

/// The line's number, drawn on the line; the numbers of lines are side by side.
std::string number_on(const ChartLine& line, std::size_t lines, double top) {
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

/// The periods of a kind, in a lane below the plot; empty if there are none.
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

std::string line_key(const ChartLine& line, bool is_numbered) {
  return concat("<span><svg class=sample viewBox=\"0 0 40 8\"><path class=l", line.style,
                " d=\"M0 4H40\"/></svg>",
                is_numbered && line.style < kNumbered ? concat(line.style + 1, " ") : "", line.name,
                "</span>\n");
}

std::string keys_of(const Chart& chart) {
  std::string html = "<p class=keys>";
  for (const ChartLine& line : chart.lines) {
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

/// The chart as a figure with a key, in HTML.
std::string drawn(const Chart& chart) {
  const double top = top_of(chart);
  std::string plot =
      text(kPlotLeft - 8, 4, "end", (top < 1 ? significant(top, 3) : fixed(top, 0)) + chart.unit) +
      text(kPlotLeft - 8, kChartHeight, "end", "0");
  for (std::size_t i = 0; i < chart.levels.size(); ++i) {
    plot += level_line(chart.levels[i], top, i);
  }
  for (const ChartLine& line : chart.lines) {
    plot += concat("<path class=l", line.style, " d=\"", path_of(line, top), "\"/>\n");
  }
  for (const ChartLine& line : chart.lines) {
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

/// Positions along the chart: more would be indistinguishable.
constexpr std::size_t kMostPlaces = 1500;

/// The chart shows distances up to this multiple of the warn distance.
constexpr double kShownFold = 5;

/// One value per period, or none.
using Values = std::vector<std::optional<double>>;

/// The worst of each `step` periods, by position along the chart.
template <class Worse>
Values folded(const Values& values, std::size_t step, const Worse& worse) {
  Values places;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % step == 0) {
      places.push_back(values[i]);
    }
    places.back() = worse(places.back(), values[i]);
  }
  return places;
}

/// The smallest known distance of all pairs; none if the guard knows no distance.
Values known_metres(const GuardedTrajectory& guarded) {
  Values values;
  for (const GuardAnswer& answer : guarded.answers) {
    const bool is_known = answer.status == Status::done && answer.pair != kNoPair;
    values.push_back(is_known ? std::optional(metres_of(guarded, answer.distance)) : std::nullopt);
  }
  return values;
}

/// The work of each period after the one that primes the guard.
Values work_of(const std::vector<GuardAnswer>& answers) {
  Values values;
  bool is_primed = false;
  for (const GuardAnswer& answer : answers) {
    values.push_back(is_primed ? std::optional<double>(answer.work) : std::nullopt);
    is_primed = is_primed || answer.status == Status::done;
  }
  return values;
}

double least_of(const Values& values) {
  double metres = HUGE_VAL;
  for (const std::optional<double>& at : values) {
    metres = std::min(metres, at.value_or(HUGE_VAL));
  }
  return metres;
}

std::vector<KindRun> runs_of(const std::vector<GuardAnswer>& answers) {
  std::vector<KindRun> runs;
  const auto count = static_cast<double>(answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const std::size_t kind = kind_of(answers[i]);
    if (runs.empty() || runs.back().kind != kind) {
      runs.push_back({static_cast<double>(i) / count, 0, kind});
    }
    runs.back().end = static_cast<double>(i + 1) / count;
  }
  return runs;
}

/// The near pairs, then the nearest other pairs that come within `most`, up to kMostLines; at least
/// one pair.
std::vector<std::uint16_t> chosen_pairs(const std::vector<NearPair>& near,
                                        const std::vector<Values>& distances, double most) {
  std::vector<std::uint16_t> pairs;
  std::transform(near.begin(), near.end(), std::back_inserter(pairs),
                 [](const NearPair& pair) { return pair.pair; });
  std::vector<std::pair<double, std::uint16_t>> others;
  for (const Values& values : distances) {
    const auto pair = static_cast<std::uint16_t>(&values - distances.data());
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) {
      others.emplace_back(least_of(values), pair);
    }
  }
  std::sort(others.begin(), others.end());
  for (const auto& [least, pair] : others) {
    if (pairs.empty() || most <= 0 || least <= most) {
      pairs.push_back(pair);
    }
  }
  pairs.resize(std::min(pairs.size(), kMostLines));
  return pairs;
}

std::uint32_t farthest_warn(const Robot& robot) {
  std::uint32_t farthest = 0;
  for (std::uint16_t pair = 0; pair < robot.pair_count; ++pair) {
    farthest = std::max(farthest, robot.pairs[pair].warn);
  }
  return farthest;
}

/// Adds a level unless it exists.
void add_level(double metres, const char* name, std::vector<ChartLevel>& levels) {
  if (std::none_of(levels.begin(), levels.end(), [&](const ChartLevel& level) {
        return level.value == metres && level.name == std::string(name);
      })) {
    levels.push_back({metres, name, name});
  }
}

/// Adds the drawn pairs and their stop and warn distances.
void add_pairs(const GuardedTrajectory& guarded, const std::vector<NearPair>& near,
               std::size_t step, double most, std::vector<ChartLine>& lines,
               std::vector<ChartLevel>& levels) {
  const std::vector<Values> distances = distances_over(guarded.robot, guarded.trajectory, step);
  for (const std::uint16_t pair : chosen_pairs(near, distances, most)) {
    lines.push_back({pair_name(guarded, pair), distances[pair], lines.size()});
    add_level(metres_of(guarded, guarded.robot.pairs[pair].stop), "stop", levels);
    add_level(metres_of(guarded, guarded.robot.pairs[pair].warn), "warn", levels);
  }
}

}  // namespace

std::string chart_section(const GuardedTrajectory& guarded, const std::vector<NearPair>& near) {
  const Trajectory& way = guarded.trajectory;
  const std::size_t step = (way.size() + kMostPlaces - 1) / kMostPlaces;
  const std::string first = concat("line ", way.line(0));
  const std::string last = concat("line ", way.line(way.size() - 1));
  const double most_shown = kShownFold * metres_of(guarded, farthest_warn(guarded.robot));
  std::vector<ChartLine> lines;
  std::vector<ChartLevel> levels;
  add_pairs(guarded, near, step, most_shown, lines, levels);
  const auto least = [](const auto& p, const auto& q) { return std::min(p, q); };
  const auto most = [](const auto& p, const auto& q) { return std::max(p, q); };
  lines.push_back({"known to the guard", folded(known_metres(guarded), step, least), kMostLines});
  Chart work = {"Work over time", "", {}, {}, 0, {}, first, last, "After the first period."};
  work.lines = {{"work of each period", folded(work_of(guarded.answers), step, most), 0}};
  if (guarded.work != kAllWork) {
    work.levels = {{static_cast<double>(guarded.work), "stop", "--work"}};
    work.caption += concat(" Dashed: what a period may spend, ", grouped(guarded.work),
                           "; a step may overdraw it.");
  }
  return section(
      "", "Distances",
      drawn({"Distances over time", " m", lines, levels, most_shown, runs_of(guarded.answers),
             first, last,
             "Distance of the meshes in each period, of the pairs that come near; dotted: the "
             "least that the guard knows of all; dashed: the stop and the warn distance. Below: "
             "what the guard says. What is far above is cut off."}) +
          (step == 1 ? "" : note(concat("One line in ", step, " is measured."))) +
          "<h3>Work</h3>\n" + drawn(work));
}

}  // namespace flashbvh::tool
