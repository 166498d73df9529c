// The largest distance of a link's points from a joint's axis, for all values of the joints in
// between. From above by the joints' sweep (support.hpp). From below, and if this does not suffice,
// by branch and bound over boxes of joint values and over the link's tree. In a box, the distance
// is bounded by its value, its gradient and a bound of all second derivatives in the middle.
#include <atomic>
#include <mutex>
#include <queue>

#include "checks.hpp"
#include "support.hpp"

namespace robot_check {
namespace {

/// The largest plausible ratio of a reach to the truth. Within twelve joints, bakers are off by
/// some parts in a thousand; beyond, by the difference between balls and shapes.
constexpr double kLoosest = 4;
constexpr std::size_t kMostJoints = 64;
/// The stored unit, 2^-26 of 1/256 cell per 2^-28 turn, in cells per radian.
const double kStored = std::ldexp(1, -26 - 8) * (1 << 28) / (2 * M_PI);

class Search {
 public:
  /// `chain`: the joints from `joint` outwards, without `joint`.
  Search(const Robot& robot, const std::vector<std::uint32_t>& chain, const Body& body)
      : body_(body) {
    for (const std::uint32_t number : chain) {
      const Joint& joint = robot.joints[number];
      whole_.push_back(range_of(joint));
      links_.push_back({&joint, {}, {}, 0});
    }
  }

  /// Whether any vertex can be farther than `limit` cells from the axis. Tests the part with the
  /// largest bound first.
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

  /// The largest distance from the axis, of all vertices placed so far.
  double farthest() const { return farthest_; }

 private:
  struct OnChain {
    const Joint* joint;
    Vec origin, axis;  ///< in the frame of the joint whose reach is checked
    double half;
  };
  struct Bound {
    double value = 0;
    double excess = 0;     ///< the part added by the box's width
    std::size_t side = 0;  ///< the side that adds most
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
    Bound most;
    for (const Vec& vertex : body_.triangles()[node.first]) {
      const Vec point = frame_.placed(vertex);
      farthest_ = std::max(farthest_, std::hypot(point.x, point.y));
      if (node.count > 1) {
        return bound_of(frame_.placed(node.centre), node.radius);
      }
      const Bound bound = bound_of(point, 0);
      most = bound.value > most.value ? bound : most;
    }
    return most;
  }

  /// The bound of all points within `radius` of `point`.
  Bound bound_of(const Vec& point, double radius) const {
    const double at = std::hypot(point.x, point.y);
    const Vec out = at > 0 ? Vec{point.x / at, point.y / at, 0} : Vec{1, 0, 0};
    const std::size_t count = links_.size();
    std::array<double, kMostJoints> lever;  // an upper bound in the box
    std::array<double, kMostJoints> parts;
    double plain = 0;  // by the joints' travel alone
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
      // A point turns about this axis after the joints between the axis and the point have moved.
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

struct Row {
  std::uint32_t link, joint;
  double stored;
  double most;  ///< proven: no vertex is farther from the axis, in cells
  std::vector<std::uint32_t> chain;
};

/// The rows from the link's own joint to the base.
std::vector<Row> rows_of(const Robot& robot, std::uint32_t link, const Body& body) {
  std::vector<Row> rows;
  std::vector<std::uint32_t> chain;
  Support support(body);
  std::size_t place = robot.links[link].first_reach;
  for (const std::uint32_t number : robot.branch(link)) {
    const Joint& joint = robot.joints[number];
    rows.push_back({link, number, 1.0 * robot.reaches[place++], support.from_axis(), chain});
    chain.insert(chain.begin(), number);
    if (joint.parent != kBase) {
      support = support.swept(joint);
    }
  }
  return rows;
}

}  // namespace

void check_reaches(const Robot& robot, const Bodies& bodies, std::size_t most_boxes,
                   Report& report) {
  std::mutex mutex;
  double nearest = HUGE_VAL;
  std::atomic<std::size_t> count{0};
  const auto check = [&](const Row& row) {
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
    const bool is_proven = row.most + kOutward <= stored;
    const Found above = is_proven ? Found::apart : search.exceeds(stored, most_boxes);
    const Found below = search.exceeds(stored / kLoosest, most_boxes);
    const std::lock_guard<std::mutex> lock(mutex);
    if (above == Found::near) {
      report.refuse(text(name, ": ", stored, " cells, but a vertex comes ", search.farthest(),
                         " from the axis: guards and motions miss what it does there"));
    } else if (above == Found::undecided || below == Found::undecided) {
      report.doubt(text(name, ": ", stored, " cells, of which ", search.farthest(),
                        " are seen and at most ", row.most, " are possible"));
    } else if (below != Found::near) {
      report.refuse(text(name, ": ", stored, " cells, more than ", kLoosest,
                         " times what any vertex reaches: guards stop for nothing"));
    }
    nearest = std::min(nearest, std::max(0.0, stored / row.most - 1));
  };
  for_each_row(robot.links.size(), [&](std::size_t link) {
    for (const Row& row : rows_of(robot, static_cast<std::uint32_t>(link), bodies[link])) {
      check(row);
      ++count;
    }
  });
  report.end("reaches", text(count.load(), " rows, none below the truth; ",
                             nearest_text(100 * nearest, "% or more")));
}

}  // namespace robot_check
