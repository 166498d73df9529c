#include "robot/charts.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <queue>

#include "flashbvh/detail/robot_chart.hpp"
#include "robot/matrix.hpp"
#include "robot/pair_space.hpp"
#include "robot/reaches.hpp"

namespace flashbvh::tool {
namespace {

/// Of the smaller link's radius: nothing is told of links that come nearer than this part of it.
constexpr double kLeastPart = 1.0 / 32;
/// Nor of what a byte can't say, in cells.
constexpr double kLeastCells = 16;
/// Of the least distance seen in a cell, what is told at least: more below so many times the least,
/// where a guard looks again every few periods.
constexpr double kNear = 6;
constexpr double kNearShare = 0.7;
constexpr double kFarShare = 0.3;

/// The largest that is no more than `distance`, in cells.
std::uint8_t byte_of(double distance) {
  std::uint32_t byte = 0;
  while (byte < 255 &&
         detail::chart_distance(static_cast<std::uint8_t>(byte + 1)) / 256.0 <= distance) {
    ++byte;
  }
  return static_cast<std::uint8_t>(byte);
}

/// A joint of the pair's, and its cells.
struct Axis {
  const RobotJoint& joint;
  std::size_t dimension;
  detail::ChartAxis cells;
  double unit;
};

/// A box of values, and what is known of it.
struct Part {
  std::vector<Interval> box;
  double least;  ///< nowhere in it are the links nearer
  Motion motion;

  bool operator<(const Part& other) const { return least > other.least; }  // the nearest first
};

class Chart {
 public:
  /// `radius`: the smaller link's, in cells.
  Chart(const PairSpace& space, double radius)
      : space_(space),
        slack_(kPlacing + space.far_origin() + 0.1),
        least_(std::max(kLeastCells, radius * kLeastPart)) {}

  /// No two places in the box are nearer. The part that may be nearest is halved, until it is
  /// nearly as far as the nearest middle.
  double distance(const std::vector<Interval>& box) {
    nearest_ = HUGE_VAL;
    std::priority_queue<Part> parts;
    parts.push(looked_at(box));
    while (nearest_ > least_) {
      const Part part = parts.top();
      const double share = nearest_ < kNear * least_ ? kNearShare : kFarShare;
      if (part.least >= share * nearest_ || part.motion.sum <= least_ / 4) {
        return std::max(0.0, part.least);
      }
      parts.pop();
      const auto most = std::max_element(part.motion.parts.begin(), part.motion.parts.end());
      const auto side = static_cast<std::size_t>(most - part.motion.parts.begin());
      const auto [lower, upper] = part.box[side];
      for (const bool is_upper : {false, true}) {
        std::vector<Interval> half = part.box;
        (is_upper ? half[side].lower : half[side].upper) = (lower + upper) / 2;
        parts.push(looked_at(half));
      }
    }
    return 0;
  }

 private:
  Part looked_at(const std::vector<Interval>& box) {
    std::vector<double> middle;
    std::vector<double> halves;
    for (const auto& [lower, upper] : box) {
      middle.push_back((lower + upper) / 2);
      halves.push_back((upper - lower) / 2);
    }
    const double apart = space_.distance(middle, seed_) - slack_;
    nearest_ = std::min(nearest_, apart);
    const Motion motion = space_.motion(middle, halves);
    return {box, apart - motion.sum, motion};
  }

  const PairSpace& space_;
  double slack_;
  double least_;
  double nearest_ = 0;
  Witness<std::uint16_t> seed_{};
};

/// A coordinate more either way, which values are rounded by.
Interval side_of(const Axis& axis, std::uint32_t cell) {
  const auto width = std::ldexp(1.0, static_cast<int>(axis.cells.shift));
  const double lower = axis.cells.lower + cell * width;
  const double upper = axis.joint.type == JointType::continuous
                           ? lower + width
                           : std::min(lower + width, static_cast<double>(axis.joint.upper));
  return {(lower - 1) * axis.unit, (upper + 1) * axis.unit};
}

std::vector<Axis> axes_of(const Model& model, const Robot& robot, const RobotPair& pair,
                          const PairSpace& space, double cell) {
  const JointsBetween between = joints_between(model, pair.a, pair.b);
  std::vector<std::size_t> joints = between.of_a;
  joints.insert(joints.end(), between.of_b.begin(), between.of_b.end());
  std::vector<Axis> axes;
  for (const std::size_t joint : joints) {
    std::size_t dimension = 0;
    while (space.dimensions()[dimension].variable != model.joints[joint].variable) {
      ++dimension;
    }
    const RobotJoint& fixed = robot.joints[joint];
    axes.push_back(
        {fixed, dimension, detail::chart_axis(fixed), unit_of_coordinate(fixed.type, cell)});
  }
  return axes;
}

void add_chart(const Model& model, const Robot& robot, const RobotPair& pair, double cell,
               std::vector<std::uint8_t>& charts) {
  const std::vector<double> reaches_a = reaches_of(model, pair.a, cell);
  const std::vector<double> reaches_b = reaches_of(model, pair.b, cell);
  const PairSpace space(model, {pair.a, &robot.meshes[pair.a], &reaches_a},
                        {pair.b, &robot.meshes[pair.b], &reaches_b}, cell);
  const std::vector<Axis> axes = axes_of(model, robot, pair, space, cell);
  const std::uint32_t radius =
      std::min(robot.links[pair.a].radius, robot.links[pair.b].radius) / kFrameCell;
  Chart chart(space, radius);
  const std::uint32_t size = detail::chart_size(robot, pair);
  for (std::uint32_t place = 0; place < size; ++place) {
    std::vector<Interval> box(axes.size());
    std::uint32_t rest = place;
    for (std::size_t i = axes.size(); i-- != 0; rest /= axes[i].cells.cells) {
      box[axes[i].dimension] = side_of(axes[i], rest % axes[i].cells.cells);
    }
    charts.push_back(byte_of(chart.distance(box)));
  }
}

}  // namespace

std::vector<std::uint8_t> charts_of(const Model& model, const Robot& robot,
                                    const std::function<void(std::size_t)>& begin) {
  double cell = 0;
  std::memcpy(&cell, &robot.cell_bits, sizeof cell);
  std::vector<std::uint8_t> charts;
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    begin(i);
    if (detail::chart_size(robot, robot.pairs[i]) != 0) {
      add_chart(model, robot, robot.pairs[i], cell, charts);
    }
  }
  return charts;
}

}  // namespace flashbvh::tool
