#include "robot/matrix/pair_search.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::tool {
namespace {

/// Added to half-widths: what doubles round of ends and middles, and what a full turn lacks between
/// the doubles next to -pi and pi. Far below 10^-4 cells.
constexpr double kOutward = 1e-11;

/// Closed.
struct Cell {
  std::vector<Interval> sides;
  int depth = 0;
};

class Search {
 public:
  Search(const PairSpace& space, const MatrixOptions& options,
         const std::function<void(double)>& progress, double distance)
      : space_(space),
        options_(options),
        progress_(progress),
        distance_(distance),
        apart_(distance + options.slack + 2 * space.far_origin()) {}

  SearchResult run() {
    Cell all;
    for (const Dimension& dimension : space_.dimensions()) {
      all.sides.push_back(dimension.range);
    }
    stack_.push_back(std::move(all));
    while (!stack_.empty()) {
      if (result_.cells == options_.most_cells) {
        result_.end = SearchEnd::cut_off;
        break;
      }
      const Cell cell = std::move(stack_.back());
      stack_.pop_back();
      if (look_at(cell)) {
        break;
      }
    }
    return std::move(result_);
  }

 private:
  /// True if the search is over.
  bool look_at(const Cell& cell) {
    if (++result_.cells % 1024 == 0 && progress_) {
      progress_(decided_);
    }
    std::vector<double> point;
    std::vector<double> halves;
    for (const auto& [lower, upper] : cell.sides) {
      const double middle = lower + (upper - lower) / 2;
      point.push_back(middle);
      halves.push_back(std::fmax(middle - lower, upper - middle) + kOutward);
    }
    const Motion motion = space_.motion(point, halves);
    if (space_.are_apart(point, motion.sum + apart_)) {
      decided_ += std::ldexp(1.0, -cell.depth);
      return false;
    }
    if (distance_ == 0 ? space_.intersect(point) : !space_.are_apart(point, apart_)) {
      result_.end = SearchEnd::near;
      result_.point = point;
      return true;
    }
    if (motion.sum <= options_.resolution) {
      result_.end = SearchEnd::unresolved;
      result_.point = point;
      decided_ += std::ldexp(1.0, -cell.depth);
      return false;
    }
    const auto most = std::max_element(motion.parts.begin(), motion.parts.end());
    const auto side = static_cast<std::size_t>(most - motion.parts.begin());
    cut(cell, side, point[side]);
    return false;
  }

  void cut(const Cell& cell, std::size_t side, double middle) {
    for (const bool upper : {true, false}) {
      Cell half = cell;
      (upper ? half.sides[side].lower : half.sides[side].upper) = middle;
      ++half.depth;
      stack_.push_back(std::move(half));
    }
  }

  const PairSpace& space_;
  const MatrixOptions& options_;
  const std::function<void(double)>& progress_;
  double distance_;
  double apart_;  ///< what suffices
  double decided_ = 0;
  SearchResult result_;
  std::vector<Cell> stack_;
};

}  // namespace

SearchResult search_pair(const PairSpace& space, const MatrixOptions& options,
                         const std::function<void(double)>& progress, double distance) {
  return Search(space, options, progress, distance).run();
}

}  // namespace flashbvh::tool
