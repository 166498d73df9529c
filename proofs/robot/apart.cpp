#include "apart.hpp"

#include <random>
#include <sstream>

namespace robot_check {
namespace {

/// Two parts that the box moves by less than this are not divided again.
constexpr double kResolution = 0.1;
/// The least step of a descent, as a part of a variable's range.
constexpr double kLeastStep = 1e-4;
/// The units by which rounding may move a coordinate; a mimic's by three.
constexpr double kRounding = 4;

/// A box of a single point.
Box box_at(const std::vector<double>& place) {
  Box box;
  for (const double value : place) {
    box.push_back({value, value});
  }
  return box;
}

/// A lower bound of the distance: the gap between the projections on a line.
double gap_along(const Vec& direction, const Triangle& t, const Triangle& u) {
  const double end = std::max({dot(direction, t[0]), dot(direction, t[1]), dot(direction, t[2])});
  const double begin = std::min({dot(direction, u[0]), dot(direction, u[1]), dot(direction, u[2])});
  return begin > end ? (begin - end) / length(direction) : 0;
}

}  // namespace

double PairSpace::PathJoint::distance(const Vec& point) const {
  return length(cross(axis, point - origin));
}

double PairSpace::PathJoint::moves(const Vec& point, double radius) const {
  return joint->slides() ? travel : travel * (distance(point) + radius);
}

PairSpace::PairSpace(const Robot& robot, std::uint32_t a, const Body& body_a, std::uint32_t b,
                     const Body& body_b)
    : robot_(robot),
      a_(body_a),
      b_(body_b),
      placed_a_(body_a.nodes().size()),
      placed_b_(body_b.nodes().size()) {
  add_path(robot, a, b);
}

void PairSpace::add_path(const Robot& robot, std::uint32_t a, std::uint32_t b) {
  const Robot::Between between = robot.between(a, b);
  std::vector<std::uint32_t> numbers = between.a;
  own_ = numbers.size();
  numbers.insert(numbers.end(), between.b.rbegin(), between.b.rend());
  for (const std::uint32_t number : numbers) {
    const Joint& joint = robot.joints[number];
    const auto known = std::find(variables_.begin(), variables_.end(), joint.variable);
    const auto dimension = static_cast<std::size_t>(known - variables_.begin());
    if (known == variables_.end()) {
      variables_.push_back(joint.variable);
    }
    PathJoint on_path{&joint, dimension, 1, 0, {}, {}, 0};
    if (joint.shift != 0) {
      const Joint& master = robot.master(joint.variable);
      on_path.scale = std::ldexp(joint.multiplier, -static_cast<int>(joint.shift)) * joint.unit() /
                      master.unit();
      on_path.offset = joint.offset * joint.unit();
    }
    path_.push_back(on_path);
  }
}

Box PairSpace::limits() const {
  Box ranges;
  for (const std::uint32_t variable : variables_) {
    const Joint& joint = robot_.master(variable);
    Range range{(joint.lower - 1.0) * joint.unit(), (joint.upper + 1.0) * joint.unit()};
    const bool is_alone = std::none_of(
        robot_.joints.begin(), robot_.joints.end(),
        [&](const Joint& other) { return other.variable == variable && other.shift != 0; });
    if (joint.is_free() || (is_alone && !joint.slides() && range.upper - range.lower >= 2 * M_PI)) {
      range = {-M_PI, M_PI};
    }
    ranges.push_back(range);
  }
  return ranges;
}

std::string PairSpace::text(const std::vector<double>& at) const {
  std::ostringstream out;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Joint& joint = robot_.master(variables_[i]);
    out << (i == 0 ? "" : ", ") << joint.name << ' ' << (joint.slides() ? robot_.cell : 1) * at[i];
  }
  return out.str();
}

/// Places the links at the middle of the box, and bounds each joint's motion.
void PairSpace::place(const Box& box) {
  ++stamp_;
  std::vector<Frame> frames(path_.size());
  Frame ends[2];
  for (const bool of_b : {false, true}) {
    Frame frame;
    const std::size_t count = of_b ? path_.size() - own_ : own_;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = of_b ? own_ + i : own_ - 1 - i;
      PathJoint& on_path = path_[place];
      const Range& range = box[on_path.dimension];
      const double half = std::fabs(on_path.scale) * (range.upper - range.lower) / 2 +
                          kRounding * on_path.joint->unit();
      on_path.travel = on_path.joint->slides() ? half : 2 * std::sin(std::min(half, M_PI) / 2);
      frame = frame * on_path.joint->moved(on_path.scale * (range.lower + range.upper) / 2 +
                                           on_path.offset);
      frames[place] = frame;
    }
    ends[of_b] = frame;
  }
  const Frame back = inverse(ends[0]);
  frame_ = back * ends[1];
  for (std::size_t i = 0; i < path_.size(); ++i) {
    path_[i].origin = back.placed(frames[i].origin);
    path_[i].axis = back.turned(frames[i].axes[2]);
  }
  choose_side();
}

/// Chooses a body between the links; joints on a's side move a, the others move b.
void PairSpace::choose_side() {
  const Body::Node& a = a_.nodes()[0];
  const Body::Node& b = b_.nodes()[0];
  const Vec centre_b = frame_.placed(b.centre);
  double sum = 0;
  for (const PathJoint& joint : path_) {
    sum += joint.moves(centre_b, b.radius);
  }
  double least = sum;
  cut_ = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    sum += path_[i].moves(a.centre, a.radius) - path_[i].moves(centre_b, b.radius);
    if (sum < least) {
      least = sum;
      cut_ = i + 1;
    }
  }
}

/// The joint farthest from the link moves first: the nearer ones still have their values in the
/// middle of the box, so each moves a point by its distance from the axis there.
double PairSpace::moved(const Vec& centre, double radius, bool of_a) const {
  double sum = 0;
  for (std::size_t i = of_a ? 0 : cut_; i < (of_a ? cut_ : path_.size()); ++i) {
    sum += path_[i].moves(centre, radius);
  }
  return sum;
}

double PairSpace::moved(const Triangle& triangle, bool of_a) const {
  return std::max(
      {moved(triangle[0], 0, of_a), moved(triangle[1], 0, of_a), moved(triangle[2], 0, of_a)});
}

const PairSpace::Placed& PairSpace::placed_a(std::uint32_t number) {
  Placed& placed = placed_a_[number];
  if (placed.box != stamp_) {
    const Body::Node& node = a_.nodes()[number];
    placed = {stamp_, node.centre, node.half, moved(node.centre, node.radius, true)};
  }
  return placed;
}

const PairSpace::Placed& PairSpace::placed_b(std::uint32_t number) {
  Placed& placed = placed_b_[number];
  if (placed.box != stamp_) {
    const Body::Node& node = b_.nodes()[number];
    const auto& [u, v, w] = frame_.axes;
    const auto extent = [&](double x, double y, double z) {
      return std::fabs(x) * node.half.x + std::fabs(y) * node.half.y + std::fabs(z) * node.half.z;
    };
    const Vec centre = frame_.placed(node.centre);
    placed = {stamp_,
              centre,
              {extent(u.x, v.x, w.x), extent(u.y, v.y, w.y), extent(u.z, v.z, w.z)},
              moved(centre, node.radius, false)};
  }
  return placed;
}

/// A lower bound of the distance of two nodes' triangles anywhere in the box.
double PairSpace::gap(std::uint32_t a, std::uint32_t b) {
  const Placed& in_a = placed_a(a);
  const Placed& in_b = placed_b(b);
  const Vec apart = in_b.centre - in_a.centre;
  const Vec boxes{std::max(0.0, std::fabs(apart.x) - in_a.half.x - in_b.half.x),
                  std::max(0.0, std::fabs(apart.y) - in_a.half.y - in_b.half.y),
                  std::max(0.0, std::fabs(apart.z) - in_a.half.z - in_b.half.z)};
  const double balls = length(apart) - a_.nodes()[a].radius - b_.nodes()[b].radius;
  return std::max(balls, length(boxes)) - in_a.moved - in_b.moved;
}

Triangle PairSpace::triangle_b(std::uint32_t node) const {
  const Triangle& t = b_.triangles()[b_.nodes()[node].first];
  return {frame_.placed(t[0]), frame_.placed(t[1]), frame_.placed(t[2])};
}

bool PairSpace::leaves_apart(std::uint32_t a, std::uint32_t b, double need) {
  const Triangle& t = a_.triangles()[a_.nodes()[a].first];
  const Triangle u = triangle_b(b);
  const Vec apart = placed_b(b).centre - placed_a(a).centre;
  if (gap_along(apart, t, u) - placed_a(a).moved - placed_b(b).moved > need) {
    return true;
  }
  near_ = {a, b, distance(t, u), moved(t, true) + moved(u, false)};
  nearest_ = std::min(nearest_, near_.distance);
  return near_.distance - near_.moved > need;
}

bool PairSpace::are_apart(std::uint32_t a, std::uint32_t b, double need) {
  if (gap(a, b) > need) {
    return true;
  }
  const Body::Node& node_a = a_.nodes()[a];
  const Body::Node& node_b = b_.nodes()[b];
  if (node_a.count == 1 && node_b.count == 1) {
    return leaves_apart(a, b, need);
  }
  const bool goes_into_a = node_b.count == 1 || (node_a.count > 1 && node_a.radius > node_b.radius);
  const auto below = [&](std::uint32_t child) {
    return goes_into_a ? std::pair(child, b) : std::pair(a, child);
  };
  auto nearer = below((goes_into_a ? a : b) + 1);
  auto farther = below(goes_into_a ? node_a.right : node_b.right);
  if (gap(farther.first, farther.second) < gap(nearer.first, nearer.second)) {
    std::swap(nearer, farther);
  }
  return are_apart(nearer.first, nearer.second, need) &&
         are_apart(farther.first, farther.second, need);
}

/// The variable that moves the two triangles most.
std::size_t PairSpace::widest(std::size_t dimensions) const {
  std::vector<double> parts(dimensions);
  const Triangle& t = a_.triangles()[a_.nodes()[near_.a].first];
  const Triangle u = triangle_b(near_.b);
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const Triangle& of = i < cut_ ? t : u;
    parts[path_[i].dimension] +=
        std::max({path_[i].moves(of[0], 0), path_[i].moves(of[1], 0), path_[i].moves(of[2], 0)});
  }
  return static_cast<std::size_t>(std::max_element(parts.begin(), parts.end()) - parts.begin());
}

/// The distance of the two links, to a thousandth of a cell.
double PairSpace::distance_at(const std::vector<double>& at) {
  place(box_at(at));
  for (PathJoint& joint : path_) {
    joint.travel = 0;
  }
  double distance = length(frame_.placed(b_.triangles()[0][0]) - a_.triangles()[0][0]);
  while (distance > 0 && !are_apart(0, 0, std::max(0.0, distance - 0.001))) {
    distance = near_.distance;
  }
  return distance;
}

/// Steps each variable in turn to bring the links nearer; halves the steps if none does.
std::vector<double> PairSpace::find_contact(int starts) {
  const Box box = limits();
  std::minstd_rand random(1);
  for (int start = 0; start < starts; ++start) {
    std::vector<double> at;
    for (const auto& [lower, upper] : box) {
      at.push_back(std::uniform_real_distribution<>(lower, upper)(random));
    }
    double nearest = distance_at(at);
    for (double step = 0.125; step > kLeastStep && nearest > 0 && !is_late();) {
      const double before = nearest;
      for (std::size_t i = 0; i < 2 * at.size() && nearest > 0; ++i) {
        const auto& [lower, upper] = box[i / 2];
        std::vector<double> next = at;
        const double way = (i % 2 == 0 ? step : -step) * (upper - lower);
        next[i / 2] = std::clamp(at[i / 2] + way, lower, upper);
        const double distance = distance_at(next);
        if (distance < nearest) {
          nearest = distance;
          at = next;
        }
      }
      step = nearest < before ? step : step / 2;
    }
    if (nearest == 0) {
      return at;
    }
  }
  return {};
}

bool PairSpace::is_within(const Box& box, double near, double most) {
  place(box);
  return !are_apart(0, 0, near) && near_.distance + near_.moved < most;
}

const Frame& PairSpace::frame_at(const Box& box) {
  place(box);
  return frame_;
}

Answer PairSpace::prove(const Box& whole, double need, double refuse, std::size_t most_boxes,
                        const std::function<bool(const Box&)>& excused) {
  struct Part {
    Box box;
    Near hint;
  };
  Answer answer;
  nearest_ = HUGE_VAL;
  std::vector<Part> waiting = {{whole, {}}};
  bool has_hint = false;
  while (!waiting.empty()) {
    const Part part = std::move(waiting.back());
    waiting.pop_back();
    std::vector<double> middle;
    for (const auto& [lower, upper] : part.box) {
      middle.push_back((lower + upper) / 2);
    }
    if (++answer.boxes > most_boxes || is_late()) {
      answer.found = Found::undecided;
      answer.at = middle;
      break;
    }
    place(part.box);
    const bool fails_at_hint = has_hint && !leaves_apart(part.hint.a, part.hint.b, need + kOutward);
    if (!fails_at_hint && are_apart(0, 0, need + kOutward)) {
      continue;
    }
    has_hint = true;
    const Near near = near_;
    if (excused && excused(part.box)) {
      continue;
    }
    if (near.distance <= refuse && !(excused && excused(box_at(middle)))) {
      answer = {Found::near, middle, near.distance, answer.boxes};
      return answer;
    }
    if (near.moved <= kResolution) {
      answer.found = Found::undecided;
      answer.at = middle;
      continue;
    }
    const std::size_t side = widest(part.box.size());
    for (const bool is_upper : {false, true}) {
      Part half{part.box, near};
      (is_upper ? half.box[side].lower : half.box[side].upper) = middle[side];
      waiting.push_back(std::move(half));
    }
  }
  answer.nearest = nearest_;
  return answer;
}

}  // namespace robot_check
