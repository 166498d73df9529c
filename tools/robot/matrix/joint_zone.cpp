#include "robot/matrix/joint_zone.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <tuple>

#include "robot/matrix/approximation.hpp"
#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Values of the joint at which links are looked at, both ends included.
constexpr std::size_t kLooks = 257;
/// Each so many of them are the first ones: they find what touches all over the range.
constexpr std::size_t kStride = 8;
/// Places tried for the zone's middle along an axis, then steps halved about the best.
constexpr std::size_t kPlaces = 16;
constexpr int kRefinements = 3;
/// The zone holds all contacts of inner looks up to this multiple of the median radius. Margins
/// cover contacts between looks.
constexpr double kMoreThanMedian = 1.25;
constexpr double kMargin = 1.02;
constexpr double kMarginCells = 2;
constexpr double kMoreAtEnds = 1.05;
/// Where links may touch outside, the zone grows up to this multiple of the median radius, and not
/// across a gap of this multiple: contacts farther out are of other parts of the links.
constexpr double kMostOfMedian = 2.25;
constexpr double kGap = 0.25;
/// Triangles at the zone's surface are cut to this part of its radius, or to so many cells.
constexpr double kCut = 1.0 / 6;
constexpr double kLeastCut = 8;
/// Contacts found between two looks at the clock.
constexpr std::size_t kContactsBetweenChecks = 256;
/// Joint boxes for the proof that links never touch outside their zone.
constexpr std::uint64_t kBoxesOutside = 4096;
/// Cells by which triangles may be farther apart than a query finds: it rounds vertices.
constexpr double kRounding = 4;

/// True if a look is not in an eighth of the range at either end.
bool is_inner(std::size_t look) {
  return look >= kLooks / 8 && look < kLooks - kLooks / 8;
}

/// One of two neighbours.
struct ZoneLink {
  std::size_t link;
  const ModelLink& chosen_by;  ///< the link, or a coarser one with the same shells
  WholeMesh mesh;              ///< of that
  double deviation;            ///< of that from the link, in metres
};

/// Finds the zone of two neighbours.
class Finder {
 public:
  Finder(const Model& model, const ZoneLink& a, const ZoneLink& b, std::size_t joint, double cell,
         const MatrixOptions& options)
      : model_(model),
        joint_(joint),
        cell_(cell),
        options_(options),
        stop_(options.of(a.link, b.link).stop),
        deviations_(a.deviation + b.deviation),
        touching_(stop_ + options.slack + options.early + 2 * kDeviation + deviations_ / cell),
        links_{a.link, b.link},
        wholes_{side_of(a.link, model.links[a.link]), side_of(b.link, model.links[b.link])},
        sides_{side_of(a.link, a.chosen_by), side_of(b.link, b.chosen_by)},
        whole_(space(a.mesh, b.mesh)) {
    options_.most_joint_boxes = kBoxesOutside;
    options_.slack += 2 * kDeviation;  // vertices at cuts are rounded again
    shape_.is_cylinder = model.joints[joint].type == JointType::prismatic;
  }

  /// None if time is up or, without a given radius, if the links are apart at one of the first
  /// looks and may touch, or stop no guard.
  std::optional<JointZone> find(std::optional<double> radius) {
    std::vector<ZoneLook> looks;
    for (std::size_t i = 0; i < kLooks; i += kStride) {
      looks.push_back(look_at(whole_, i));
      passes_ = passes_ || (!radius && looks.back().contacts.empty());
      if ((passes_ && (!are_kept_apart() || has_own_stop())) || deadline_is_past()) {
        return std::nullopt;
      }
    }
    if (!passes_) {
      touching_shells_ = take_touching_shells(sides_, looks);
    } else if (take_all_shells(); are_apart_outside() || !never_touch()) {
      return std::nullopt;
    }
    place(looks);
    if (radius) {
      shape_.radius = *radius;
    } else if (passes_) {
      grow_until_apart();
    } else {
      grow();
    }
    JointZone zone = {links_[0], links_[1], joint_, shape_, hidden_, bodies()};
    return deadline_is_past() ? std::nullopt : std::optional(std::move(zone));
  }

  /// True if find() ran out of time.
  bool is_late() const { return is_late_; }

 private:
  bool deadline_is_past() {
    is_late_ = is_late_ || options_.is_late();
    return is_late_;
  }

  ZoneSide side_of(std::size_t link, const ModelLink& chosen_by) const {
    const bool is_moved = model_.links[link].joint == joint_;
    return ZoneSide(chosen_by, is_moved ? Transform() : model_.joints[joint_].fixed);
  }

  PairSpace space(const WholeMesh& a, const WholeMesh& b) const {
    return PairSpace(model_, {links_[0], a}, {links_[1], b}, cell_);
  }

  /// Value `number` of kLooks.
  static double value_at(const PairSpace& space, std::size_t number) {
    const auto [lower, upper] = space.dimensions()[0].range;
    return lower + (upper - lower) * static_cast<double>(number) / static_cast<double>(kLooks - 1);
  }

  /// Finds what touches at that value; not all of it if time is up.
  ZoneLook look_at(const PairSpace& space, std::size_t number) const {
    const double value = value_at(space, number);
    ZoneLook look = {number, space.frame_at({value}), {}};
    space.find_near({value}, touching_, [&](std::uint32_t a, std::uint32_t b) {
      look.contacts.push_back({a, b});
      return look.contacts.size() % kContactsBetweenChecks != 0 || !options_.is_late();
    });
    return look;
  }

  /// The triangles of a contact in the joint's frame on side a.
  std::array<PointTriangle, 2> triangles_of(const ZoneLook& look,
                                            const std::array<std::uint32_t, 2>& contact,
                                            const bake::SourceMesh& a,
                                            const bake::SourceMesh& b) const {
    const Transform& to_joint = sides_[0].to_joint();
    return {placed_triangle(to_joint, simplify::triangle_of(a, a.triangles[contact[0]])),
            placed_triangle(composed(to_joint, look.frame),
                            simplify::triangle_of(b, b.triangles[contact[1]]))};
  }

  /// The radius of the smallest zone outside of which nothing touches; 0 if nothing does anywhere.
  double radius_at(const ZoneLook& look, const bake::SourceMesh& a,
                   const bake::SourceMesh& b) const {
    double radius = 0;
    for (const auto& contact : look.contacts) {
      const auto [p, q] = triangles_of(look, contact, a, b);
      radius = radius_between(shape_, p, q, (touching_ + kRounding) * cell_, radius);
    }
    return radius == 0 ? 0 : radius * kMargin + kMarginCells * cell_ + deviations_;
  }

  /// Chooses the middle with the smallest radius, among contacts.
  void place(const std::vector<ZoneLook>& looks) {
    simplify::Box all;
    for (const ZoneLook& look : looks) {
      for (const auto& contact : look.contacts) {
        const auto [p, q] = triangles_of(look, contact, sides_[0].mesh(), sides_[1].mesh());
        for (const Vector3& corner : p) {
          all.add(corner);
        }
      }
    }
    take_radius(looks);
    for (std::size_t axis = shape_.is_cylinder ? 0 : 2; axis < (shape_.is_cylinder ? 2 : 3);
         ++axis) {
      double step = (all.high[axis] - all.low[axis]) / kPlaces;
      for (std::size_t i = 0; i <= kPlaces; ++i) {
        try_middle(axis, all.low[axis] + static_cast<double>(i) * step, looks);
      }
      for (int i = 0; i < kRefinements; ++i) {
        step /= 2;
        const double best = shape_.middle[axis];
        try_middle(axis, best - step, looks);
        try_middle(axis, best + step, looks);
      }
    }
  }

  /// Takes another middle if its radius is smaller.
  void try_middle(std::size_t axis, double at, const std::vector<ZoneLook>& looks) {
    const auto before = std::pair(shape_, median_);
    shape_.middle[axis] = at;
    take_radius(looks);
    if (shape_.radius >= before.first.radius) {
      std::tie(shape_, median_) = before;
    }
  }

  /// Sets the radius and the median one.
  void take_radius(const std::vector<ZoneLook>& looks) {
    std::vector<double> radii;
    double most = 0;
    for (const ZoneLook& look : looks) {
      radii.push_back(radius_at(look, sides_[0].mesh(), sides_[1].mesh()));
      most = is_inner(look.number) ? std::max(most, radii.back()) : most;
    }
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    median_ = *middle;
    shape_.radius = passes_ ? *std::max_element(radii.begin(), radii.end())
                            : std::min(most, kMoreThanMedian * median_);
  }

  /// Grows the zone to contacts between the first looks, by little at the ends of the range. Then,
  /// where a guard would stop: to all of the links if they never touch, or else not too far.
  void grow() {
    std::vector<double> radii(kLooks);  // that the zone needs for what touches outside; or 0
    for (const ZoneBodies& of : outside(sides_)) {
      const PairSpace pair = space(of.a.view(), of.b.view());
      for (std::size_t i = 0; i < kLooks && !options_.is_late(); ++i) {
        radii[i] = radius_at(look_at(pair, i), of.mesh_a, of.mesh_b);
      }
    }
    const double at_ends = kMoreAtEnds * shape_.radius;
    for (std::size_t i = 0; i < radii.size(); ++i) {
      if (radii[i] <= (is_inner(i) ? kMoreThanMedian * median_ : at_ends)) {
        shape_.radius = std::max(shape_.radius, radii[i]);
      }
    }
    if (deadline_is_past()) {
      return;
    }
    if (never_touch()) {
      if (are_kept_apart()) {
        grow_until_apart();
      }
      return;
    }
    std::sort(radii.begin(), radii.end());
    for (const double radius : radii) {
      if (radius > shape_.radius &&
          radius <= std::min(kMostOfMedian * median_, shape_.radius + kGap * median_)) {
        shape_.radius = radius;
        hidden_ += 1.0 / kLooks;
      }
    }
  }

  void take_all_shells() {
    for (std::size_t side = 0; side < 2; ++side) {
      touching_shells_[side].assign(sides_[side].shell_count(), true);
    }
  }

  /// Grows the zone of links that never touch, for all of their shells, until all looks are apart.
  void grow_until_apart() {
    take_all_shells();
    double high = HUGE_VAL;
    for (std::size_t side = 0; side < 2; ++side) {
      double most = 0;
      for (const Vector3& vertex : wholes_[side].mesh().vertices) {
        most = std::max(most, shape_.distance_of(placed(sides_[side].to_joint(), vertex)));
      }
      high = std::min(high, most);
    }
    double low = shape_.radius;
    if (are_apart_outside()) {
      return;
    }
    while (high > kMargin * low && !deadline_is_past()) {
      shape_.radius = 0.5 * (low + high);
      (are_apart_outside() ? high : low) = shape_.radius;
    }
    shape_.radius = high + deviations_;
  }

  /// True if what is outside the zone is apart at all looks.
  bool are_apart_outside() const {
    for (const ZoneBodies& of : outside(sides_)) {
      const PairSpace pair = space(of.a.view(), of.b.view());
      for (std::size_t i = 0; i < kLooks; ++i) {
        if (!pair.are_apart({value_at(pair, i)}, touching_)) {
          return false;
        }
      }
    }
    return true;
  }

  /// True if links that never touch have to be guarded for their stop distance.
  bool are_kept_apart() const {
    return stop_ > 0 &&
           (find_pair(model_.disabled, links_[0], links_[1]) == nullptr || has_own_stop());
  }

  bool has_own_stop() const { return find_pair(options_.own, links_[0], links_[1]) != nullptr; }

  /// True if it is proven that nothing outside the zone ever touches.
  bool never_touch() const {
    const std::vector<ZoneBodies> all = bodies();
    return std::all_of(all.begin(), all.end(), [&](const ZoneBodies& of) {
      return search_pair(space(of.a.view(), of.b.view()), options_).end == SearchEnd::apart;
    });
  }

  /// Adds the bodies, unless one of them is empty.
  void add_bodies(bake::SourceMesh a, bake::SourceMesh b, std::vector<ZoneBodies>& all) const {
    if (!a.triangles.empty() && !b.triangles.empty()) {
      ZoneBodies made = {std::move(a), std::move(b), {}, {}};
      made.a = bake_part(made.mesh_a, cell_);
      made.b = bake_part(made.mesh_b, cell_);
      all.push_back(std::move(made));
    }
  }

  /// What the touching shells have outside the zone: no bodies or two.
  std::vector<ZoneBodies> outside(const std::array<ZoneSide, 2>& sides) const {
    const double edge = std::max(kCut * shape_.radius, kLeastCut * cell_);
    std::vector<ZoneBodies> all;
    add_bodies(sides[0].outside(touching_shells_[0], shape_, edge),
               sides[1].outside(touching_shells_[1], shape_, edge), all);
    return all;
  }

  /// All but what touches in the zone: outside it; other shells and the other link.
  std::vector<ZoneBodies> bodies() const {
    std::vector<ZoneBodies> all = outside(wholes_);
    std::array<std::vector<bool>, 2> others = touching_shells_;
    others[0].flip();
    others[1].flip();
    add_bodies(wholes_[0].part(others[0]), wholes_[1].mesh(), all);
    add_bodies(wholes_[0].part(touching_shells_[0]), wholes_[1].part(others[1]), all);
    return all;
  }

  const Model& model_;
  std::size_t joint_;
  double cell_;
  MatrixOptions options_;
  double stop_;        ///< in cells
  double deviations_;  ///< of the sides from the links, in metres
  double touching_;    ///< in cells: distance that counts as contact
  bool is_late_ = false;
  bool passes_ = false;  ///< apart at some values, but within the stop distance at others
  std::array<std::size_t, 2> links_;
  std::array<ZoneSide, 2> wholes_;
  std::array<ZoneSide, 2> sides_;  ///< the links, or coarser ones
  PairSpace whole_;                ///< of these
  std::array<std::vector<bool>, 2> touching_shells_;
  ZoneShape shape_;
  double median_ = 0;  ///< of the radii for single values, in metres
  double hidden_ = 0;
};

}  // namespace

std::string radius_text(const Model& model, double radius, std::size_t joint) {
  return concat(metres(radius, 4), " about ", model.joints[joint].name);
}

FoundZones joint_zones(const Model& model, const std::vector<WholeMesh>& meshes, double cell,
                       const MatrixOptions& options, const ZoneRadii& radii) {
  FoundZones all;
  std::mutex mutex;
  const std::vector<std::optional<Approximation>> others = approximations(model, cell, options);
  for_each_in_parallel(model.neighbours.size(), [&](std::size_t i) {
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
    const auto link = [&](std::size_t number) -> ZoneLink {
      const std::optional<Approximation>& of = others[number];
      return of ? ZoneLink{number, of->link, of->baked.view(), of->length}
                : ZoneLink{number, model.links[number], meshes[number], 0};
    };
    Finder finder(model, link(a), link(b), *joint, cell, options);
    std::optional<JointZone> zone = finder.find(radius);
    const std::lock_guard<std::mutex> lock(mutex);
    if (zone) {
      all.zones.push_back(std::move(*zone));
    }
    if (finder.is_late()) {
      all.late_joints.insert(*joint);
    }
  });
  std::sort(all.zones.begin(), all.zones.end(), [](const JointZone& p, const JointZone& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return all;
}

}  // namespace flashbvh::tool
