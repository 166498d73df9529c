#include "robot/matrix/joint_zone.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "robot/matrix/approximation.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Sampled values of the joint, both ends included.
constexpr std::size_t kLooks = 33;
/// The zone's middle is that of all contacts, or of those over the middle half of the range.
constexpr std::size_t kQuarter = kLooks / 4;
/// The zone holds all contacts but those of an eighth of the samples at either end of the range ...
constexpr std::size_t kEnds = kLooks / 8;
/// ... up to this multiple of the samples' median radius. Margins cover contacts between samples.
constexpr double kMoreThanMedian = 1.25;
constexpr double kMargin = 1.02;
constexpr double kMarginCells = 2;
/// Steps from one sample to the next when the zone is grown.
constexpr std::size_t kBetween = 8;
constexpr double kMoreAtEnds = 1.05;
/// Triangles are cut to this part of the zone, so that it holds little that does not touch.
constexpr double kCut = 1.0 / 6;
/// The smallest length to which triangles are cut, in cells.
constexpr double kLeastCut = 8;
/// Rounds of measuring the zone, each with triangles cut by the zone of the last one.
constexpr int kRounds = 3;

struct Contact {
  std::uint32_t a;  ///< triangles of the two sides
  std::uint32_t b;
};

/// The joint's frame at coordinate 0, in the frame of a link next to it.
Transform frame_in(const Model& model, std::size_t link, std::size_t joint) {
  return model.links[link].joint == joint ? Transform() : model.joints[joint].fixed;
}

/// Finds the zone of two neighbours.
class Finder {
 public:
  Finder(const Model& model, std::size_t a, std::size_t b, std::size_t joint, double cell,
         const MatrixOptions& options)
      : model_(model),
        joint_(joint),
        cell_(cell),
        edge_(options.distances_of(a, b).stop + options.slack),
        touching_(edge_ + options.early),
        deadline_(options.deadline),
        links_{a, b},
        frames_{frame_in(model, a, joint), frame_in(model, b, joint)},
        sides_{ZoneSide(model.links[a], frames_[0]), ZoneSide(model.links[b], frames_[1])} {
    shape_.is_cylinder = model.joints[joint].type == JointType::prismatic;
  }

  /// Chooses the zone by coarser links with the same shells. `deviations`: of both, in metres.
  void choose_by(const ModelLink& a, const ModelLink& b, double deviations) {
    touching_ += deviations / cell_;
    whole_sides_ = std::move(sides_);
    sides_ = {ZoneSide(a, frames_[0]), ZoneSide(b, frames_[1])};
  }

  /// None if time is up or, without a given radius, if the links are apart at a sample. The meshes:
  /// of the links, or of the coarser links.
  std::optional<JointZone> find(const WholeMesh& mesh_a, const WholeMesh& mesh_b,
                                std::optional<double> radius) {
    const PairSpace whole = space(mesh_a, mesh_b);
    look_over(whole.dimensions()[0].range);
    if (!radius && std::any_of(looks_.begin(), looks_.end(),
                               [&](double value) { return whole.are_apart({value}, touching_); })) {
      return std::nullopt;
    }
    const std::vector<std::vector<Contact>> contacts = contacts_in(whole);
    if (deadline_.is_past()) {
      is_late_ = true;
      return std::nullopt;
    }
    find_touching_shells(contacts);
    place(contacts);
    shape_.radius = radius ? *radius : radius_of(contacts);
    for (int round = 0; round < kRounds && shape_.radius > 0 && !deadline_.is_past(); ++round) {
      const double before = shape_.radius;
      cut();
      if (radius) {
        break;
      }
      const BakedPart a = bake_part(sides_[0].mesh(), cell_);
      const BakedPart b = bake_part(sides_[1].mesh(), cell_);
      shape_.radius = std::min(before, radius_of(contacts_in(space(a.view(), b.view()))));
      if (shape_.radius > 0.9 * before) {
        break;
      }
    }
    if (!radius) {
      grow();
    }
    if (whole_sides_) {
      sides_ = std::move(*whole_sides_);
      cut();
    }
    is_late_ = deadline_.is_past();
    return is_late_ ? std::nullopt : std::optional(zone());
  }

  /// True if find() ran out of time.
  bool is_late() const { return is_late_; }

 private:
  PairSpace space(const WholeMesh& a, const WholeMesh& b) const {
    return PairSpace(model_, {links_[0], a}, {links_[1], b}, cell_);
  }

  void look_over(const Interval& range) {
    for (std::size_t i = 0; i < kLooks; ++i) {
      looks_.push_back(range.lower + (range.upper - range.lower) * static_cast<double>(i) /
                                         static_cast<double>(kLooks - 1));
    }
  }

  std::vector<std::vector<Contact>> contacts_in(const PairSpace& space) const {
    std::vector<std::vector<Contact>> contacts(kLooks);
    for (std::size_t i = 0; i < kLooks && !deadline_.is_past(); ++i) {
      space.find_near({looks_[i]}, touching_, [&](std::uint32_t a, std::uint32_t b) {
        contacts[i].push_back({a, b});
      });
    }
    return contacts;
  }

  /// Finds the shells that touch at half of the samples or more.
  void find_touching_shells(const std::vector<std::vector<Contact>>& contacts) {
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<std::size_t> counts(sides_[side].shell_count());
      for (const std::vector<Contact>& look : contacts) {
        std::set<std::uint32_t> touching;
        for (const Contact& contact : look) {
          touching.insert(sides_[side].shell_of(side == 0 ? contact.a : contact.b));
        }
        for (const std::uint32_t shell : touching) {
          ++counts[shell];
        }
      }
      for (const std::size_t count : counts) {
        touching_shells_[side].push_back(2 * count >= kLooks);
      }
    }
  }

  bool is_of_zone(const Contact& contact) const {
    return touching_shells_[0][sides_[0].shell_of(contact.a)] &&
           touching_shells_[1][sides_[1].shell_of(contact.b)];
  }

  /// Chooses the middle with the smaller radius: contacts at an end of the range may lie far off.
  void place(const std::vector<std::vector<Contact>>& contacts) {
    place_middle(contacts, 0);
    const ZoneShape of_all = shape_;
    const double radius = radius_of(contacts);
    place_middle(contacts, kQuarter);
    if (radius_of(contacts) >= radius) {
      shape_ = of_all;
    }
  }

  /// Sets the middle to that of the contacts, without `ends` samples at either end, along the axes
  /// that the joint leaves unmoved.
  void place_middle(const std::vector<std::vector<Contact>>& contacts, std::size_t ends) {
    const auto extent = [&](std::size_t side, std::uint32_t triangle, std::size_t axis) {
      Interval of{HUGE_VAL, -HUGE_VAL};
      for (std::size_t i = 0; i < 3; ++i) {
        const double at = sides_[side].corner(triangle, i)[axis];
        of = {std::min(of.lower, at), std::max(of.upper, at)};
      }
      return of;
    };
    for (std::size_t axis = shape_.is_cylinder ? 0 : 2; axis < (shape_.is_cylinder ? 2 : 3);
         ++axis) {
      Interval all{HUGE_VAL, -HUGE_VAL};
      for (std::size_t look = ends; look < kLooks - ends; ++look) {
        for (const Contact& contact : contacts[look]) {
          if (is_of_zone(contact)) {
            const Interval a = extent(0, contact.a, axis);
            const Interval b = extent(1, contact.b, axis);
            const double low = std::max(a.lower, b.lower);
            const double high = std::min(a.upper, b.upper);
            all = {std::min({all.lower, low, high}), std::max({all.upper, low, high})};
          }
        }
      }
      shape_.middle[axis] = all.lower <= all.upper ? 0.5 * (all.lower + all.upper) : 0;
    }
  }

  /// The radius of the smallest zone that holds one triangle of each contact of a sample, or 0.
  double least_radius(const std::vector<Contact>& look, const std::vector<double>& farthest_a,
                      const std::vector<double>& farthest_b) const {
    double radius = 0;
    for (const Contact& contact : look) {
      if (is_of_zone(contact)) {
        radius = std::max(radius, std::min(farthest_a[contact.a], farthest_b[contact.b]));
      }
    }
    return radius;
  }

  /// Grows the zone to contacts between samples, by little at the ends of the range.
  void grow() {
    const std::vector<std::uint32_t> numbers_a = triangles(0, Which::outside);
    const std::vector<std::uint32_t> numbers_b = triangles(1, Which::outside);
    if (numbers_a.empty() || numbers_b.empty()) {
      return;
    }
    const BakedPart a = bake_part(part_of(sides_[0].mesh(), numbers_a), cell_);
    const BakedPart b = bake_part(part_of(sides_[1].mesh(), numbers_b), cell_);
    const PairSpace outside = space(a.view(), b.view());
    const std::vector<double> farthest_a = sides_[0].farthest(shape_);
    const std::vector<double> farthest_b = sides_[1].farthest(shape_);
    const double largest_at_ends = kMoreAtEnds * shape_.radius;
    for (std::size_t i = 0; i <= kBetween * (kLooks - 1) && !deadline_.is_past(); ++i) {
      const bool is_end = i < kBetween * kEnds || i > kBetween * (kLooks - 1 - kEnds);
      const double part = static_cast<double>(i) / static_cast<double>(kBetween * (kLooks - 1));
      const double value = looks_.front() + part * (looks_.back() - looks_.front());
      double needed = 0;
      if (!outside.are_apart({value}, touching_)) {
        outside.find_near({value}, touching_, [&](std::uint32_t p, std::uint32_t q) {
          needed = std::max(needed, std::min(farthest_a[numbers_a[p]], farthest_b[numbers_b[q]]));
        });
      }
      needed = needed * kMargin + kMarginCells * cell_;
      if (needed <= (is_end ? largest_at_ends : largest_)) {
        shape_.radius = std::max(shape_.radius, needed);
      }
    }
  }

  double radius_of(const std::vector<std::vector<Contact>>& contacts) {
    const std::vector<double> farthest_a = sides_[0].farthest(shape_);
    const std::vector<double> farthest_b = sides_[1].farthest(shape_);
    std::vector<double> radii;
    radii.reserve(contacts.size());
    for (const std::vector<Contact>& look : contacts) {
      radii.push_back(least_radius(look, farthest_a, farthest_b));
    }
    const double most = *std::max_element(radii.begin() + kEnds, radii.end() - kEnds);
    std::nth_element(radii.begin(), radii.begin() + kLooks / 2, radii.end());
    largest_ = kMoreThanMedian * radii[kLooks / 2] * kMargin + kMarginCells * cell_;
    return std::min(most * kMargin + kMarginCells * cell_, largest_);
  }

  void cut() {
    const double edge = std::max({kCut * shape_.radius, edge_ * cell_, kLeastCut * cell_});
    for (std::size_t side = 0; side < 2; ++side) {
      sides_[side].cut(touching_shells_[side], shape_, edge);
    }
  }

  /// Triangles of touching shells outside the zone, of touching shells, of other shells, or all.
  enum class Which : std::uint8_t { outside, touching, other, all };
  std::vector<std::uint32_t> triangles(std::size_t side, Which which) const {
    const std::vector<double> farthest = sides_[side].farthest(shape_);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < farthest.size(); ++i) {
      const bool touches = touching_shells_[side][sides_[side].shell_of(i)];
      if (which == Which::all || (which == Which::other) != touches) {
        if (which != Which::outside || farthest[i] > shape_.radius) {
          numbers.push_back(i);
        }
      }
    }
    return numbers;
  }

  void add_bodies(Which of_a, Which of_b, std::vector<ZoneBodies>& bodies) const {
    const std::vector<std::uint32_t> a = triangles(0, of_a);
    const std::vector<std::uint32_t> b = triangles(1, of_b);
    if (!a.empty() && !b.empty()) {
      ZoneBodies made = {sides_[0].part(a), sides_[1].part(b), {}, {}};
      made.a = bake_part(made.mesh_a, cell_);
      made.b = bake_part(made.mesh_b, cell_);
      bodies.push_back(std::move(made));
    }
  }

  JointZone zone() const {
    JointZone zone = {links_[0], links_[1], joint_, shape_, {}};
    add_bodies(Which::outside, Which::outside, zone.bodies);
    add_bodies(Which::other, Which::all, zone.bodies);
    add_bodies(Which::touching, Which::other, zone.bodies);
    return zone;
  }

  const Model& model_;
  std::size_t joint_;
  double cell_;
  double edge_;      ///< in cells: triangles are cut no finer
  double touching_;  ///< in cells: distance that counts as contact
  Deadline deadline_;
  bool is_late_ = false;
  std::array<std::size_t, 2> links_;
  std::array<Transform, 2> frames_;  ///< the joint's frame in the links'
  std::array<ZoneSide, 2> sides_;
  std::optional<std::array<ZoneSide, 2>>
      whole_sides_;            ///< of the links, if coarser ones are in use
  std::vector<double> looks_;  ///< sampled values of the joint's variable
  std::array<std::vector<bool>, 2> touching_shells_;
  ZoneShape shape_;
  double largest_ = 0;  ///< largest radius that the zone may have
};

}  // namespace

std::string radius_text(const Model& model, double radius, std::size_t joint) {
  return concat(significant(radius, 4), " m about ", model.joints[joint].name);
}

StopDistance MatrixOptions::distances_of(std::size_t a, std::size_t b) const {
  const StopDistance* const own = find_pair(stops, a, b);
  return own != nullptr ? *own : StopDistance{a, b, stop, warn};
}

std::optional<std::size_t> joint_of_neighbours(const Model& model, std::size_t a, std::size_t b) {
  const JointsBetween joints = joints_between(model, a, b);
  if (joints.of_a.size() + joints.of_b.size() != 1) {
    return std::nullopt;
  }
  return joints.of_a.empty() ? joints.of_b[0] : joints.of_a[0];
}

bool is_between_neighbours(const Model& model, std::size_t joint) {
  return std::any_of(model.neighbours.begin(), model.neighbours.end(), [&](const auto& pair) {
    return joint_of_neighbours(model, pair.first, pair.second) == joint;
  });
}

FoundZones joint_zones(const Model& model, const std::vector<WholeMesh>& meshes, double cell,
                       const MatrixOptions& options, const ZoneRadii& radii) {
  std::vector<std::optional<JointZone>> found(model.neighbours.size());
  std::vector<std::optional<std::size_t>> late_joints(found.size());
  const std::vector<std::optional<Approximation>> others = approximations(model, cell, options);
  for_each_in_parallel(found.size(), [&](std::size_t i) {
    const auto [a, b] = std::minmax(model.neighbours[i].first, model.neighbours[i].second);
    const std::optional<std::size_t> joint = joint_of_neighbours(model, a, b);
    if (!joint) {
      return;
    }
    const auto given = radii.find(*joint);
    const std::optional<double> radius =
        given == radii.end() ? std::nullopt : std::optional(given->second);
    if (radius == 0.0) {
      return;
    }
    Finder finder(model, a, b, *joint, cell, options);
    if (others[a] || others[b]) {
      finder.choose_by(others[a] ? others[a]->link : model.links[a],
                       others[b] ? others[b]->link : model.links[b],
                       (others[a] ? others[a]->length : 0) + (others[b] ? others[b]->length : 0));
    }
    found[i] = finder.find(others[a] ? others[a]->baked.view() : meshes[a],
                           others[b] ? others[b]->baked.view() : meshes[b], radius);
    late_joints[i] = finder.is_late() ? joint : std::nullopt;
  });
  FoundZones all;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i]) {
      all.zones.push_back(std::move(*found[i]));
    }
    if (late_joints[i]) {
      all.late_joints.insert(*late_joints[i]);
    }
  }
  std::sort(all.zones.begin(), all.zones.end(), [](const JointZone& p, const JointZone& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return all;
}

}  // namespace flashbvh::tool
