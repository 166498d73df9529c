// How far a joint's axis is from any point of a link beyond it, at most, wherever the joints
// between stand: branch and bound over boxes of their values and the link's tree at once. In a box
// the distance is bounded by its value, its gradient and a bound of all second derivatives in the
// middle; the same bound decides "farther than the stored reach" and "as far as a quarter of it".
#include <mutex>
#include <queue>

#include "checks.hpp"

namespace robot_check {
namespace {

/// A reach this many times the truth is nonsense. Within twelve joints bakers are off by some parts
/// in a thousand; beyond, by what balls lose against shapes.
constexpr double kLoosest = 4;
/// Of a polygon that takes a circle's place.
constexpr int kCorners = 96;
/// Radians that the innermost joint must turn for circles to take the place of its arcs.
constexpr double kNearlyWhole = 4.7;
constexpr std::size_t kMostJoints = 64;
/// For what doubles round, in cells.
constexpr double kOutward = 1e-6;
/// 2^-26 of 1/256 cell a unit of 2^-28 of a turn, in cells a radian.
const double kStored = std::ldexp(1, -26 - 8) * (1 << 28) / (2 * M_PI);

class Search {
 public:
  /// `chain`: joints from `joint` outwards, without it.
  Search(const Robot& robot, const std::vector<std::uint32_t>& chain, const Body& body)
      : body_(body) {
    for (const std::uint32_t number : chain) {
      const Joint& joint = robot.joints[number];
      const bool is_whole =
          joint.is_free() || (!joint.slides() && (1.0 * joint.upper - joint.lower) >= (1 << 28));
      whole_.push_back(is_whole ? Range{-M_PI, M_PI}
                                : Range{joint.lower * joint.unit(), joint.upper * joint.unit()});
      links_.push_back({&joint, {}, {}, 0});
    }
  }

  /// Whether the innermost joint turns nearly all the way.
  bool ends_in_circles() const {
    return !whole_.empty() && !links_.back().joint->slides() &&
           whole_.back().upper - whole_.back().lower > kNearlyWhole;
  }
  void hold_innermost() { whole_.back() = {0, 0}; }

  /// Whether any vertex can be farther than `limit` cells from the axis. What may reach farthest
  /// is looked at first.
  Found exceeds(double limit, std::size_t most_boxes) {
    std::priority_queue<Part> waiting;
    const auto add = [&](Box box, std::uint32_t node) {
      place(box);
      const Bound bound = bound_of(node);
      if (bound.value + kOutward > limit) {
        waiting.push({std::move(box), node, bound});
      }
    };
    add(whole_, 0);
    for (std::size_t boxes = 0; !waiting.empty(); ++boxes) {
      if (farthest_ > limit) {
        return Found::near;
      }
      const Part part = waiting.top();
      waiting.pop();
      const Body::Node& node = body_.nodes()[part.node];
      if (node.count > 1 && node.radius >= part.bound.excess) {
        add(part.box, node.right);
        add(part.box, part.node + 1);
        continue;
      }
      if (boxes >= most_boxes || part.bound.excess < kOutward) {
        return Found::undecided;
      }
      const std::size_t side = part.bound.side;
      const double middle = (part.box[side].lower + part.box[side].upper) / 2;
      for (const bool is_upper : {false, true}) {
        Box half = part.box;
        (is_upper ? half[side].lower : half[side].upper) = middle;
        add(std::move(half), part.node);
      }
    }
    return Found::apart;
  }

  /// Of all vertices that were placed, the largest distance from the axis.
  double farthest() const { return farthest_; }

 private:
  struct OnChain {
    const Joint* joint;
    Vec origin, axis;  ///< in the frame of the joint whose reach it is
    double half;
  };
  struct Bound {
    double value = 0;
    double excess = 0;     ///< what the box's width adds
    std::size_t side = 0;  ///< that adds most of it
  };
  struct Part {
    Box box;
    std::uint32_t node;
    Bound bound;
    bool operator<(const Part& other) const { return bound.value < other.bound.value; }
  };

  void place(const Box& box) {
    frame_ = Frame();
    for (std::size_t i = 0; i < links_.size(); ++i) {
      frame_ = frame_ * links_[i].joint->moved((box[i].lower + box[i].upper) / 2);
      links_[i].origin = frame_.origin;
      links_[i].axis = frame_.axes[2];
      links_[i].half = (box[i].upper - box[i].lower) / 2;
    }
  }

  Bound bound_of(std::uint32_t number) {
    const Body::Node& node = body_.nodes()[number];
    if (node.count > 1) {
      return bound_of(frame_.placed(node.centre), node.radius);
    }
    Bound most;
    for (const Vec& vertex : body_.triangles()[node.first]) {
      const Vec point = frame_.placed(vertex);
      farthest_ = std::max(farthest_, std::hypot(point.x, point.y));
      const Bound bound = bound_of(point, 0);
      most = bound.value > most.value ? bound : most;
    }
    return most;
  }

  /// Of all points within `radius` of one.
  Bound bound_of(const Vec& point, double radius) const {
    const double at = std::hypot(point.x, point.y);
    const Vec out = at > 0 ? Vec{point.x / at, point.y / at, 0} : Vec{1, 0, 0};
    const std::size_t count = links_.size();
    std::array<double, kMostJoints> lever;  // at most, in the box
    std::array<double, kMostJoints> parts;
    double plain = 0;  // by the ways alone
    double outwards = 0;
    double sideways = 0;
    double rest = 0;
    double inner = 0;
    for (std::size_t i = count; i-- != 0;) {
      const OnChain& link = links_[i];
      const bool slides = link.joint->slides();
      const Vec speed = slides ? link.axis : cross(link.axis, point - link.origin);
      const double way =
          slides ? link.half : 2 * std::sin(std::min(link.half, M_PI) / 2) * length(speed);
      // A point turns about this axis as joints between it and the point have moved it.
      lever[i] = slides ? 1 : length(speed) + inner;
      inner += slides ? link.half : lever[i] * link.half;
      plain += way;
      const double to_outwards = std::fabs(dot(out, speed)) * link.half;
      outwards += to_outwards;
      sideways += std::fabs(out.x * speed.y - out.y * speed.x) * link.half;
      parts[i] = to_outwards;
      for (std::size_t k = i; k < count && !slides; ++k) {
        const double part = (k == i ? 0.5 : 1) * lever[k] * link.half * links_[k].half;
        rest += part;
        parts[i] += part / 2;
        parts[k] += part / 2;
      }
    }
    const double curved = std::hypot(at + outwards + rest, sideways + rest);
    Bound bound;
    bound.excess = std::min(plain, curved - at);
    bound.value = at + bound.excess + radius;
    const auto end = parts.begin() + static_cast<std::ptrdiff_t>(count);
    bound.side = static_cast<std::size_t>(std::max_element(parts.begin(), end) - parts.begin());
    return bound;
  }

  const Body& body_;
  Box whole_;
  std::vector<OnChain> links_;
  Frame frame_;
  double farthest_ = 0;
};

/// Corners of polygons round the circles on which a joint turns the link's vertices: those circles
/// alone that lie outermost, by height along the axis and radius.
Body turned_about(const Body& body) {
  std::vector<std::pair<double, double>> circles;
  for (const Triangle& triangle : body.triangles()) {
    for (const Vec& v : triangle) {
      circles.emplace_back(v.z, std::hypot(v.x, v.y));
    }
  }
  std::sort(circles.begin(), circles.end());
  std::vector<std::pair<double, double>> outer;
  for (const auto& [z, radius] : circles) {
    const auto is_inside = [&, z = z, radius = radius] {
      const auto& p = outer[outer.size() - 2];
      const auto& q = outer.back();
      return (q.second - p.second) * (z - p.first) <= (radius - p.second) * (q.first - p.first);
    };
    while (outer.size() > 1 && is_inside()) {
      outer.pop_back();
    }
    outer.emplace_back(z, radius);
  }
  std::vector<Triangle> corners;
  for (const auto& [z, radius] : outer) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2 * M_PI * i / kCorners;
      const double out = radius / std::cos(M_PI / kCorners);
      const Vec corner{out * std::cos(angle), out * std::sin(angle), z};
      corners.push_back({corner, corner, corner});
    }
  }
  return Body(std::move(corners));
}

struct Row {
  std::uint32_t link, joint;
  double stored;
  std::vector<std::uint32_t> chain;
};

std::vector<Row> rows_of(const Robot& robot) {
  std::vector<Row> rows;
  for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
    std::vector<std::uint32_t> chain;
    std::size_t place = robot.links[link].first_reach;
    for (const std::uint32_t joint : robot.branch(link)) {
      rows.push_back({link, joint, 1.0 * robot.reaches[place++], chain});
      chain.insert(chain.begin(), joint);
    }
  }
  return rows;
}

bool is_proven_by_circles(const Robot& robot, const Row& row, const Body& body, double stored,
                          std::size_t most_boxes) {
  Search search(robot, row.chain, body);
  if (!search.ends_in_circles()) {
    return false;
  }
  const Body circles = turned_about(body);
  Search of_circles(robot, row.chain, circles);
  of_circles.hold_innermost();
  return of_circles.exceeds(stored, most_boxes) == Found::apart;
}

}  // namespace

void check_reaches(const Robot& robot, const Bodies& bodies, std::size_t most_boxes,
                   Report& report) {
  const std::vector<Row> rows = rows_of(robot);
  std::mutex mutex;
  double nearest = HUGE_VAL;
  for_each_row(rows.size(), [&](std::size_t i) {
    const Row& row = rows[i];
    const std::string name =
        text("reach of joint ", robot.joints[row.joint].name, ", link ", robot.link_name(row.link));
    if (robot.joints[row.joint].slides()) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (row.stored != 1 << 23) {
        report.refuse(text(name, ": ", row.stored, ", but that of a slide is ", 1 << 23));
      }
      return;
    }
    const double stored = row.stored * kStored;
    Search search(robot, row.chain, bodies[row.link]);
    const Found above = is_proven_by_circles(robot, row, bodies[row.link], stored, most_boxes)
                            ? Found::apart
                            : search.exceeds(stored, most_boxes);
    const Found below = search.exceeds(stored / kLoosest, most_boxes);
    const std::lock_guard<std::mutex> lock(mutex);
    if (above == Found::near) {
      report.refuse(text(name, ": ", stored, " cells, but a vertex comes ", search.farthest(),
                         " from the axis: guards and motions miss what it does there"));
    } else if (above == Found::undecided || below == Found::undecided) {
      report.doubt(text(name, ": ", stored, " cells, of which ", search.farthest(), " are seen"));
    } else if (below != Found::near) {
      report.refuse(text(name, ": ", stored, " cells, more than ", kLoosest,
                         " times what any vertex reaches: guards stop for nothing"));
    }
    nearest = std::min(nearest, stored / search.farthest() - 1);
  });
  report.end("reaches", text(rows.size(), " rows, none below the truth; the nearest is at most ",
                             100 * nearest, " % above"));
}

}  // namespace robot_check
