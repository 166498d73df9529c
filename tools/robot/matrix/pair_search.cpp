#include "robot/matrix/pair_search.hpp"

#include <algorithm>
#include <cmath>

#include "robot/matrix/reaches.hpp"
#include "robot/matrix/swept_pair.hpp"

namespace flashbvh::tool {
namespace {

/// Added to half-widths: covers the rounding of ends and middles, and the rest of a full turn
/// beyond the doubles next to -pi and pi. Far below 10^-4 cells.
constexpr double kOutward = 1e-11;

/// A closed joint box.
using JointBox = std::vector<Interval>;

class Search {
 public:
  Search(const PairSpace& space, const MatrixOptions& options, double distance)
      : space_(space),
        options_(options),
        distance_(distance),
        apart_(distance + options.slack + 2 * space.far_origin()) {}

  SearchResult run() {
    JointBox all;
    for (const Dimension& dimension : space_.dimensions()) {
      all.push_back(dimension.range);
    }
    stack_.push_back(std::move(all));
    while (!stack_.empty()) {
      if (result_.joint_boxes == options_.most_joint_boxes || options_.is_late()) {
        result_.end = SearchEnd::cut_off;
        break;
      }
      const JointBox box = std::move(stack_.back());
      stack_.pop_back();
      if (look_at(box)) {
        break;
      }
    }
    return std::move(result_);
  }

 private:
  /// Returns true if the search is over.
  bool look_at(const JointBox& box) {
    ++result_.joint_boxes;
    std::vector<double> point;
    std::vector<double> halves;
    for (const auto& [lower, upper] : box) {
      const double middle = lower + (upper - lower) / 2;
      point.push_back(middle);
      halves.push_back(std::fmax(middle - lower, upper - middle) + kOutward);
    }
    const Motion motion = space_.motion(point, halves);
    if (space_.are_apart(point, motion.sum + apart_)) {
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
      return false;
    }
    const auto most = std::max_element(motion.parts.begin(), motion.parts.end());
    const auto side = static_cast<std::size_t>(most - motion.parts.begin());
    cut(box, side, point[side]);
    return false;
  }

  void cut(const JointBox& box, std::size_t side, double middle) {
    for (const bool upper : {true, false}) {
      JointBox half = box;
      (upper ? half[side].lower : half[side].upper) = middle;
      stack_.push_back(std::move(half));
    }
  }

  const PairSpace& space_;
  const MatrixOptions& options_;
  double distance_;
  double apart_;  ///< sufficient distance without motion
  SearchResult result_;
  std::vector<JointBox> stack_;
};

/// The share of MatrixOptions::most_joint_boxes for a proof that may fail: one in so many.
constexpr std::uint64_t kShare = 4;

/// Surfaces that meet nowhere in a joint box stay inside or outside each other: testing one point
/// of the box suffices.
bool is_proven(const SweptPair& pair, const std::vector<SweptEnd>& ends,
               const MatrixOptions& options, std::uint64_t& joint_boxes, double distance) {
  const auto reaches = [&](std::size_t link) {
    return reaches_of(pair.model, link, pair.cell, options.deadline);
  };
  const std::vector<double> reaches_a = reaches(pair.link_a);
  const std::vector<double> reaches_b = reaches(pair.link_b);
  const PairSpace space(pair.model, {pair.link_a, pair.a.view(), &reaches_a},
                        {pair.link_b, pair.b.view(), &reaches_b}, pair.cell);
  const SearchResult found = search_pair(space, options, distance);
  joint_boxes += found.joint_boxes;
  if (found.end != SearchEnd::apart) {
    return false;
  }
  std::vector<double> any_point;
  for (const Dimension& dimension : space.dimensions()) {
    any_point.push_back(dimension.range.lower);
  }
  return std::none_of(ends.begin(), ends.end(), [&](const SweptEnd& end) {
    return is_any_inside(pair, end, space.variables_at(any_point));
  });
}

/// The number of descents.
constexpr std::size_t kDescents = 16;
/// Steps begin at a quarter of the ranges and are halved at most this often.
constexpr int kHalvings = 14;
/// Most steps of a descent, so that one along a valley ends.
constexpr int kMostSteps = 300;
/// The first step of deepened(), as a part of the range.
constexpr double kFirstStep = 1.0 / (1 << 16);

struct Place {
  double distance;
  std::vector<double> point;
  Witness<WholeMesh::Index> hint;
};

/// Radical inverse: the digits of `number` in base `base`, mirrored at the point. In (0, 1).
double mirrored(std::uint32_t number, std::uint32_t base) {
  double sum = 0;
  double digit = 1.0 / base;
  for (; number != 0; number /= base) {
    sum += digit * (number % base);
    digit /= base;
  }
  return sum;
}

/// One for each joint that a robot may have.
constexpr std::uint32_t kPrimes[kMaxJoints] = {
    2,   3,   5,   7,   11,  13,  17,  19,  23,  29,  31,  37,  41,  43,  47,  53,
    59,  61,  67,  71,  73,  79,  83,  89,  97,  101, 103, 107, 109, 113, 127, 131,
    137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223,
    227, 229, 233, 239, 241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307, 311};

/// Moves each variable by a step up or down if that brings the links nearer. False if none does.
bool step_down(const PairSpace& space, double scale, Place& place) {
  bool moved = false;
  for (std::size_t i = 0; i < place.point.size(); ++i) {
    const Interval& range = space.dimensions()[i].range;
    for (const double direction : {scale, -scale}) {
      Place next = place;
      double& value = next.point[i];
      value = std::clamp(value + direction * (range.upper - range.lower), range.lower, range.upper);
      if (value == place.point[i]) {
        continue;
      }
      next.distance = space.distance(next.point, next.hint);
      if (next.distance < place.distance) {
        place = next;
        moved = true;
        break;
      }
    }
  }
  return moved;
}

/// Descends until the distance is 0, the smallest step fails, or steps or time run out.
void go_down(const PairSpace& space, const MatrixOptions& options, Place& place) {
  int halvings = 0;
  for (int step = 0; step < kMostSteps && halvings < kHalvings && place.distance > 0; ++step) {
    if (options.is_late()) {
      return;
    }
    if (!step_down(space, std::ldexp(0.25, -halvings), place)) {
      ++halvings;
    }
  }
}

/// The last value of a variable, up or down from `point`, at which doubling steps still intersect.
double last_intersecting(const PairSpace& space, const std::vector<double>& point, std::size_t i,
                         double direction) {
  const Interval& range = space.dimensions()[i].range;
  std::vector<double> next = point;
  double last = point[i];
  double step = kFirstStep;
  while (step < 1) {
    const double to = point[i] + direction * step * (range.upper - range.lower);
    next[i] = std::clamp(to, range.lower, range.upper);
    if (next[i] == last || !space.intersect(next)) {
      break;
    }
    last = next[i];
    step *= 2;
  }
  return last;
}

}  // namespace

SearchResult search_pair(const PairSpace& space, const MatrixOptions& options, double distance) {
  return Search(space, options, distance).run();
}

bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, std::uint64_t& joint_boxes, double distance) {
  const std::optional<SweptEnd> end_a = swept_end(model, a, b);
  const std::optional<SweptEnd> end_b = swept_end(model, b, a);
  std::vector<std::vector<SweptEnd>> choices;
  if (end_a && end_b && end_a->joint != end_b->joint) {
    choices.push_back({*end_a, *end_b});
  }
  for (const std::optional<SweptEnd>& end : {end_b, end_a}) {
    if (end) {
      choices.push_back({*end});
    }
  }
  MatrixOptions share = options;
  share.most_joint_boxes = options.most_joint_boxes / kShare;
  // The other link was rounded to the old lattice and is rounded to the new one.
  share.slack += 2 * kDeviation;
  return std::any_of(choices.begin(), choices.end(), [&](const std::vector<SweptEnd>& ends) {
    if (options.is_late()) {
      return false;
    }
    const SweptPair pair = swept_pair(model, a, b, cell, ends, kCoarse);
    return is_proven(pair, ends, share, joint_boxes, distance);
  });
}

std::vector<double> deepened(const PairSpace& space, std::vector<double> point) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    std::vector<double> next = point;
    const double low = last_intersecting(space, point, i, -1);
    next[i] = low + (last_intersecting(space, point, i, 1) - low) / 2;
    if (space.intersect(next)) {
      point = next;
    }
  }
  return point;
}

std::vector<double> spread_point(const PairSpace& space, std::uint32_t number) {
  std::vector<double> point;
  for (std::size_t i = 0; i < space.dimensions().size(); ++i) {
    const auto [lower, upper] = space.dimensions()[i].range;
    point.push_back(lower + mirrored(number + 1, kPrimes[i]) * (upper - lower));
  }
  return point;
}

bool intersect_wherever_tried(const PairSpace& space, std::uint32_t places) {
  std::uint32_t place = 0;
  while (place < places && space.intersect(spread_point(space, place))) {
    ++place;
  }
  return place == places;
}

std::optional<std::vector<double>> find_intersection(const PairSpace& space,
                                                     const MatrixOptions& options,
                                                     std::uint32_t starts) {
  std::vector<Place> places;
  for (std::uint32_t i = 0; i < starts && !options.is_late(); ++i) {
    Place place = {0, spread_point(space, i), {}};
    place.distance = space.distance(place.point, place.hint);
    if (place.distance == 0 && space.intersect(place.point)) {
      return place.point;
    }
    places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance < b.distance; });
  places.resize(std::min(places.size(), kDescents));
  for (Place& place : places) {
    if (options.is_late()) {
      break;
    }
    go_down(space, options, place);
    if (place.distance == 0 && space.intersect(place.point)) {
      return place.point;
    }
  }
  return std::nullopt;
}

}  // namespace flashbvh::tool
