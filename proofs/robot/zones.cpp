// All contact of two neighbours about the joint between them lies in their zone, or at values at
// which a guarded part of them stops a guard. The image contains a zone's radius but not its
// middle: this is the point with the least distance to the farthest contact, at many values of the
// joint. Turning about the joint's axis, or sliding along it, maps the zone to itself.
#include "checks.hpp"

namespace robot_check {
namespace {

/// The number of values of the joint at which contact is searched for.
constexpr int kLooks = 33;
/// The share of the radius below which a link's pieces are not divided again.
constexpr double kPiece = 1.0 / 32;
/// The share of a guard's stop distance and slack within which triangles excuse contact in a box.
constexpr double kCertain = 0.75;
/// The rounding error of corners, in cells.
constexpr double kRounded = 1;

double longest_edge(const Triangle& t) {
  return std::max({length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
}

std::array<Triangle, 2> halves(const Triangle& t) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (length(t[(i + 1) % 3] - t[i]) > length(t[(longest + 1) % 3] - t[longest])) {
      longest = i;
    }
  }
  const Vec& p = t[longest];
  const Vec& q = t[(longest + 1) % 3];
  const Vec& r = t[(longest + 2) % 3];
  const Vec middle = 0.5 * (p + q);
  return {Triangle{p, middle, r}, Triangle{middle, q, r}};
}

Vec centroid(const Triangle& t) {
  return 1.0 / 3 * (t[0] + t[1] + t[2]);
}

class Zone {
 public:
  Zone(const Robot& robot, const Bodies& bodies, const Unguarded& pair)
      : robot_(robot),
        bodies_(bodies),
        pair_(pair),
        joint_(robot.joints[pair.joint]),
        radius_(pair.radius / 256.0),
        near_((robot.links[pair.a].deviation + robot.links[pair.b].deviation) / 256.0),
        space_(robot, pair.a, bodies[pair.a], pair.b, bodies[pair.b]) {
    for (const Pair& guarded : robot.pairs) {
      const std::uint32_t a = robot.whole_of(guarded.a);
      const std::uint32_t b = robot.whole_of(guarded.b);
      if (std::min(a, b) == pair.a && std::max(a, b) == pair.b) {
        parts_.emplace_back(robot, guarded.a, bodies[guarded.a], guarded.b, bodies[guarded.b]);
        stops_.push_back((guarded.stop + robot.slack) / 256.0);
      }
    }
  }

  void check(std::size_t most_boxes, Report& report) {
    const std::string row = text("zone of ", robot_.pair_name(pair_.a, pair_.b), ", ", radius_,
                                 " cells about ", joint_.name);
    const double needed = find_middle();
    const Body a = outside(pair_.a);
    const Body b = outside(pair_.b);
    if (a.nodes().empty() || b.nodes().empty()) {
      return;
    }
    PairSpace space(robot_, pair_.a, a, pair_.b, b);
    const Answer answer = space.prove(space.limits(), near_, 0, most_boxes,
                                      [&](const Box& box) { return is_excused(box); });
    if (answer.found == Found::apart) {
      return;
    }
    if (needed > radius_) {
      report.refuse(text(row, ": contact reaches ", needed, " cells, as at ", space.text(answer.at),
                         ", where no part of the two is guarded"));
    } else {
      report.doubt(
          text(row, ": contact about ", space.text(answer.at), " is neither in it nor excluded"));
    }
  }

 private:
  /// Whether some guarded part stops a guard in the whole box.
  bool is_excused(const Box& box) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].is_within(box, kCertain * stops_[i], stops_[i])) {
        return true;
      }
    }
    return false;
  }

  /// The transform from the link's frame to the joint's, at its coordinate 0.
  Frame to_joint(std::uint32_t link) const {
    return robot_.links[link].joint == pair_.joint ? Frame() : inverse(joint_.fixed);
  }

  double from_middle(const Vec& point) const {
    const Vec off = point - middle_;
    return length({off.x, off.y, joint_.slides() ? 0 : off.z});
  }

  /// The largest distance of contact from the best middle, up to half a piece.
  double find_middle() {
    const Range range = space_.limits()[0];
    for (int i = 0; i < kLooks; ++i) {
      const double value = range.lower + (range.upper - range.lower) * i / (kLooks - 1);
      if (!is_excused({{value, value}})) {
        const Frame b_in_a = space_.frame_at({{value, value}});
        for (const Triangle& t : bodies_[pair_.b].triangles()) {
          add_contacts(t, b_in_a);
        }
      }
    }
    Vec middle;
    for (int step = 1; step <= 200 && !contacts_.empty(); ++step) {
      middle = middle + 1.0 / (step + 1) * (contacts_[farthest()] - middle_);
      middle_ = joint_.slides() ? Vec{middle.x, middle.y, 0} : Vec{0, 0, middle.z};
    }
    return contacts_.empty() ? 0 : from_middle(contacts_[farthest()]) - kPiece * radius_;
  }

  std::size_t farthest() const {
    std::size_t most = 0;
    for (std::size_t i = 1; i < contacts_.size(); ++i) {
      most = from_middle(contacts_[i]) > from_middle(contacts_[most]) ? i : most;
    }
    return most;
  }

  void add_contacts(const Triangle& of_b, const Frame& b_in_a) {
    const Vec centre = centroid(of_b);
    const double size =
        std::max({length(of_b[0] - centre), length(of_b[1] - centre), length(of_b[2] - centre)});
    if (bodies_[pair_.a].distance(b_in_a.placed(centre), size + near_) >= size + near_) {
      return;
    }
    if (size <= kPiece * radius_) {
      contacts_.push_back(to_joint(pair_.b).placed(centre));
      return;
    }
    for (const Triangle& half : halves(of_b)) {
      add_contacts(half, b_in_a);
    }
  }

  /// The part of a link that is not wholly in the zone.
  Body outside(std::uint32_t link) const {
    std::vector<Triangle> kept;
    const Frame frame = to_joint(link);
    for (const Triangle& t : bodies_[link].triangles()) {
      keep_outside(t, frame, kept);
    }
    return Body(std::move(kept));
  }

  void keep_outside(const Triangle& t, const Frame& frame, std::vector<Triangle>& kept) const {
    double farthest = 0;
    for (const Vec& corner : t) {
      farthest = std::max(farthest, from_middle(frame.placed(corner)));
    }
    if (farthest <= radius_ + kRounded) {
      return;
    }
    const double edge = longest_edge(t);
    if (edge <= kPiece * radius_ || from_middle(frame.placed(centroid(t))) - edge > radius_) {
      kept.push_back(t);
      return;
    }
    for (const Triangle& half : halves(t)) {
      keep_outside(half, frame, kept);
    }
  }

  const Robot& robot_;
  const Bodies& bodies_;
  const Unguarded& pair_;
  const Joint& joint_;
  double radius_;  ///< cells
  double near_;    ///< the distance in cells within which the URDF's links may touch
  PairSpace space_;
  std::vector<PairSpace> parts_;
  std::vector<double> stops_;  ///< of each
  Vec middle_;                 ///< in the joint's frame
  std::vector<Vec> contacts_;  ///< in the joint's frame
};

}  // namespace

void check_zones(const Robot& robot, const Bodies& bodies, std::size_t most_boxes, Report& report) {
  std::size_t zones = 0;
  for (const Unguarded& pair : robot.unguarded) {
    if (pair.why == 0) {
      Zone(robot, bodies, pair).check(most_boxes, report);
      ++zones;
    }
  }
  report.end("zones", text(zones, " zones hold all contact that no part is guarded for; ",
                           robot.unguarded.size() - zones, " pairs are believed, not checked"));
}

}  // namespace robot_check
