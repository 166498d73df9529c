#include "robot/baked/fixed_robot.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <queue>

#include "flashbvh/robot/distance_table.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/matrix/swept_pair.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Distances below this part of the smaller link's radius are stored as 0.
constexpr double kLeastPart = 1.0 / 32;
/// Distances below a byte's smallest, in cells, are stored as 0.
constexpr double kLeastCells = 16;
/// A stored distance is at least this share of the least distance seen in its table cell. The share
/// is larger below kNear times the smallest distance: there a guard checks again every few periods.
constexpr double kNear = 6;
struct Shares {
  double near;
  double far;
};
constexpr Shares kShares{0.7, 0.3};
/// Larger shares, so that a row's proven distance suffices for its table cells.
constexpr Shares kRowShares{0.8, 0.4};

/// The largest byte whose distance is at most `distance`, in cells.
std::uint8_t byte_of(double distance) {
  std::uint32_t byte = 0;
  while (byte < 255 && table_distance(static_cast<std::uint8_t>(byte + 1)) / 256.0 <= distance) {
    ++byte;
  }
  return static_cast<std::uint8_t>(byte);
}

/// A joint between the links, and its table cells.
struct Axis {
  const RobotJoint& joint;
  std::size_t dimension;
  DistanceTableAxis cells;
  double unit;
};

/// A box of joint values and the bound known for it.
struct Part {
  std::vector<Interval> box;
  double least;  ///< lower bound on the links' distance in the box
  Motion motion;

  bool operator<(const Part& other) const { return least > other.least; }  // the nearest first
};

template <class Space>
class DistanceTable {
 public:
  /// `radius`: of the smaller link; `deviation`: bound on the meshes' displacement, in addition to
  /// placing. Both in cells.
  DistanceTable(const Space& space, double radius, double deviation, const Shares& shares,
                const Deadline& deadline)
      : space_(space),
        shares_(shares),
        deadline_(deadline),
        slack_(kPlacing + space.far_origin() + 0.1 + deviation),
        least_(std::max(kLeastCells, radius * kLeastPart)) {}

  /// A lower bound on the links' distance in the box; `known`: another such bound. Halves the part
  /// that may be nearest until its bound is close to the least distance at a part's middle.
  double distance(const std::vector<Interval>& box, double known = 0) {
    nearest_ = HUGE_VAL;
    std::priority_queue<Part> parts;
    parts.push(looked_at(box));
    while (nearest_ > least_ && !deadline_.is_past()) {
      const Part part = parts.top();
      const double share = nearest_ < kNear * least_ ? shares_.near : shares_.far;
      const double least = std::max(known, part.least);
      if (least >= share * nearest_ || part.motion.sum <= least_ / 4) {
        return least;
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
    const double apart = space_.distance(middle, hint_) - slack_;
    nearest_ = std::min(nearest_, apart);
    const Motion motion = space_.motion(middle, halves);
    return {box, apart - motion.sum, motion};
  }

  const Space& space_;
  Shares shares_;
  Deadline deadline_;
  double slack_;
  double least_;
  double nearest_ = 0;
  typename Space::Hint hint_{};
};

/// One link swept a full turn about the joint next to it: a distance from the swept solid holds for
/// all table cells of that joint at once.
class SweptDistanceTable {
 public:
  SweptDistanceTable(const Model& model, const RobotPair& pair, const SweptEnd& end, double radius,
                     double cell, const Deadline& deadline)
      : end_(end),
        pair_(swept_pair(model, pair.a, pair.b, cell, {end}, kFine)),
        scale_(pair_.cell / cell),
        space_(pair_.model, {pair.a, pair_.a.view()}, {pair.b, pair_.b.view()}, pair_.cell),
        table_(space_, radius / scale_, 2 * kDeviation, kRowShares, deadline),
        dimension_(space_.dimension_of(model.joints[end.joint].variable)) {}

  /// In the robot's cells. Cached for boxes that differ in the swept joint alone.
  double distance(std::vector<Interval> box) {
    const Interval held = space_.dimensions()[dimension_].range;
    box[dimension_] = {held.lower, held.lower};
    const Interval row = box[1 - dimension_];
    const auto place = kept_.find(row.lower);
    if (place != kept_.end()) {
      return place->second;
    }
    const std::vector<double> variables = space_.variables_at({box[0].lower, box[1].lower});
    const double found = is_any_inside(pair_, end_, variables) ? 0 : table_.distance(box);
    return kept_[row.lower] = scale_ * found;
  }

 private:
  SweptEnd end_;
  SweptPair pair_;
  double scale_;
  PairSpace space_;
  DistanceTable<PairSpace> table_;
  std::size_t dimension_;
  std::map<double, double> kept_;
};

/// For a pair with two joints between its links.
std::vector<std::unique_ptr<SweptDistanceTable>> swept_tables(const Model& model,
                                                              const RobotPair& pair, double radius,
                                                              double cell,
                                                              const Deadline& deadline) {
  std::vector<std::unique_ptr<SweptDistanceTable>> distance_tables;
  for (const auto& [link, other] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
    const std::optional<SweptEnd> end = swept_end(model, link, other);
    if (end && !deadline.is_past()) {
      distance_tables.push_back(
          std::make_unique<SweptDistanceTable>(model, pair, *end, radius, cell, deadline));
    }
  }
  return distance_tables;
}

/// The values of a table cell, widened by one unit at both ends since values are rounded.
Interval side_of(const Axis& axis, std::uint32_t cell) {
  const auto width = std::ldexp(1.0, static_cast<int>(axis.cells.shift));
  const double lower = axis.cells.lower + cell * width;
  const double upper = axis.joint.type == JointType::continuous
                           ? lower + width
                           : std::min(lower + width, static_cast<double>(axis.joint.upper));
  return {(lower - 1) * axis.unit, (upper + 1) * axis.unit};
}

std::vector<Axis> axes_of(const Model& model, const Robot& robot, const RobotPair& pair,
                          const FirmwarePairSpace& space, double cell) {
  const JointsBetween between = joints_between(model, pair.a, pair.b);
  std::vector<std::size_t> joints = between.of_a;
  joints.insert(joints.end(), between.of_b.begin(), between.of_b.end());
  std::vector<Axis> axes;
  for (const std::size_t joint : joints) {
    const RobotJoint& fixed = robot.joints[joint];
    axes.push_back({fixed, space.dimension_of(model.joints[joint].variable),
                    distance_table_axis(fixed), unit_of_coordinate(fixed.type, cell)});
  }
  return axes;
}

std::vector<std::uint8_t> distance_table_of(const Model& model, const Robot& robot,
                                            const RobotPair& pair, const Deadline& deadline) {
  const std::uint32_t size = distance_table_size(robot, pair);
  std::vector<std::uint8_t> bytes;
  if (size == 0 || deadline.is_past()) {
    return std::vector<std::uint8_t>(size);
  }
  const double cell = cell_of(robot);
  const FirmwarePairSpace space(model, {pair.a, robot.meshes[pair.a]},
                                {pair.b, robot.meshes[pair.b]}, cell);
  const std::vector<Axis> axes = axes_of(model, robot, pair, space, cell);
  const std::uint32_t radius =
      std::min(robot.links[pair.a].radius, robot.links[pair.b].radius) / kFrameCell;
  DistanceTable<FirmwarePairSpace> distance_table(space, radius, 0, kShares, deadline);
  const auto swept = swept_tables(model, pair, radius, cell, deadline);
  for (std::uint32_t place = 0; place < size && !deadline.is_past(); ++place) {
    std::vector<Interval> box(axes.size());
    std::uint32_t rest = place;
    for (std::size_t i = axes.size(); i-- != 0; rest /= axes[i].cells.cells) {
      box[axes[i].dimension] = side_of(axes[i], rest % axes[i].cells.cells);
    }
    double known = 0;
    for (const auto& all : swept) {
      known = std::max(known, all->distance(box));
    }
    bytes.push_back(byte_of(distance_table.distance(box, known)));
  }
  bytes.resize(size);  // 0: unknown
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> distance_tables_of(const Model& model, const Robot& robot,
                                             const Deadline& deadline) {
  std::vector<std::vector<std::uint8_t>> tables(robot.pair_count);
  for_each_in_parallel(tables.size(), [&](std::size_t i) {
    tables[i] = distance_table_of(model, robot, robot.pairs[i], deadline);
  });
  std::vector<std::uint8_t> all;
  for (const std::vector<std::uint8_t>& table : tables) {
    all.insert(all.end(), table.begin(), table.end());
  }
  return all;
}

}  // namespace flashbvh::tool
