#include "robot/matrix/matrix.hpp"

#include <algorithm>
#include <mutex>

#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Joint boxes searched before the search for a witness: most proofs take fewer.
constexpr std::uint64_t kFewJointBoxes = 4096;
/// Most joint boxes for a proof that spares firmware a pair.
constexpr std::uint64_t kManyJointBoxes = 65536;
/// Points from which the search for a witness starts.
constexpr std::uint32_t kStarts = 256;

std::string counted_boxes(std::uint64_t joint_boxes) {
  return concat(joint_boxes, joint_boxes == 1 ? " joint box" : " joint boxes");
}

std::string proven(std::uint64_t joint_boxes) {
  return "proven for all values within the limits, " + counted_boxes(joint_boxes);
}

/// Higher is worse.
int rank_of(MatrixVerdict verdict) {
  return verdict == MatrixVerdict::can         ? 3
         : verdict == MatrixVerdict::believed  ? 2
         : verdict == MatrixVerdict::undecided ? 1
                                               : 0;
}

/// Decides one pair.
class Decider {
 public:
  Decider(const Model& model, const PairLink& a, const PairLink& b, double cell,
          const MatrixOptions& options)
      : model_(model), space_(model, a, b, cell), cell_(cell), options_(options) {}

  void decide(PairVerdict& pair) const {
    if (space_.dimensions().empty()) {
      pair.verdict = MatrixVerdict::fixed;
      pair.reason =
          concat("no joint moves them, ", space_.intersect({}) ? "intersecting" : "apart");
      return;
    }
    search(pair);
    if (!is_left_out(pair)) {
      guard(pair);
    }
  }

 private:
  /// True if the SRDF exempts a decided pair from being guarded.
  bool is_left_out(PairVerdict& pair) const {
    const DisabledPair* const disabled = find_pair(model_.disabled, pair.a, pair.b);
    if (disabled == nullptr) {
      return false;
    }
    if (pair.verdict == MatrixVerdict::never) {
      const bool has_no_stop = find_pair(options_.own, pair.a, pair.b) == nullptr;
      pair.reason += has_no_stop ? "; disabled in the SRDF, so not kept --stop apart" : "";
      return has_no_stop;
    }
    if (disabled->is_believed) {
      pair.verdict = MatrixVerdict::believed;
      pair.reason += "; disabled in the SRDF and believed";
    } else if (pair.verdict == MatrixVerdict::undecided || pair.zone) {
      pair.reason += "; disabled in the SRDF, guarded all the same";
    }
    return disabled->is_believed;
  }

  /// Sets whether a guard has to test the pair, and what the guard would report.
  void guard(PairVerdict& pair) const {
    const auto [a, b, stop, warn] = options_.of(pair.a, pair.b);
    pair.is_guarded = true;
    if (pair.verdict == MatrixVerdict::never) {
      const std::uint64_t before = pair.joint_boxes;
      pair.is_guarded = stop > 0 && !stays_away(stop, pair);
      pair.reason += stop > 0 ? concat("; ", pair.joint_boxes - before, " more for --stop") : "";
    }
    if (!pair.is_guarded) {
      return;
    }
    if (pair.zone) {
      add_stops(stop + options_.early + options_.tenth(stop), pair);
    } else {
      pair.is_stopped = is_within(stop + options_.early + options_.tenth(stop));
      pair.is_warned = !pair.is_stopped && is_within(warn);
    }
  }

  /// Searches a few joint boxes, then for a witness, then all joint boxes.
  void search(PairVerdict& pair) const {
    MatrixOptions few = options_;
    few.most_joint_boxes = std::min(options_.most_joint_boxes, kFewJointBoxes);
    SearchResult found = search_pair(space_, few);
    pair.joint_boxes = found.joint_boxes;
    if (found.end == SearchEnd::cut_off || found.end == SearchEnd::unresolved) {
      if (auto point = find_intersection(space_, options_, kStarts)) {
        found.end = SearchEnd::near;
        found.point = std::move(*point);
      }
    }
    if (found.end == SearchEnd::cut_off && few.most_joint_boxes < options_.most_joint_boxes) {
      if (is_swept_away(options_, pair, 0)) {
        pair.verdict = MatrixVerdict::never;
        pair.reason = proven(pair.joint_boxes) + ", by solids of revolution";
        return;
      }
      found = search_pair(space_, options_);
      pair.joint_boxes += found.joint_boxes;
    }
    conclude(found, pair);
  }

  /// Not for pairs with a zone: solids of revolution are of whole links, and need a second joint.
  bool is_swept_away(const MatrixOptions& options, PairVerdict& pair, double distance) const {
    return !pair.zone && !options.is_late() &&
           is_proven_swept(model_, pair.a, pair.b, cell_, options, pair.joint_boxes, distance);
  }

  /// True if the links are proven to stay farther apart than the stop distance.
  bool stays_away(double stop, PairVerdict& pair) const {
    MatrixOptions few = options_;
    few.most_joint_boxes = std::min(options_.most_joint_boxes, kManyJointBoxes);
    const SearchResult found = search_pair(space_, few, stop);
    pair.joint_boxes += found.joint_boxes;
    return found.end == SearchEnd::apart ||
           (found.end == SearchEnd::cut_off && is_swept_away(few, pair, stop));
  }

  bool is_within(double distance) const {
    for (std::uint32_t i = 0; i < options_.looks; ++i) {
      if (options_.is_late() ||
          space_.are_apart(spread_point(space_, i), distance + options_.slack)) {
        return false;
      }
    }
    return options_.looks != 0;
  }

  /// Adds the values at which a guard would stop the links.
  void add_stops(double distance, PairVerdict& pair) const {
    pair.stops.resize(options_.looks);
    for (std::uint32_t i = 0; i < options_.looks && !options_.is_late(); ++i) {
      pair.stops[i] =
          pair.stops[i] || !space_.are_apart(spread_point(space_, i), distance + options_.slack);
    }
  }

  /// Moves a witness into the limits if it stays one: ranges are a little wider than limits.
  std::vector<double> within_limits(const std::vector<double>& point) const {
    std::vector<double> within = point;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const ModelJoint& joint = model_.joints[model_.variables[space_.dimensions()[i].variable]];
      within[i] = std::clamp(point[i], joint.lower, joint.upper);
    }
    return space_.intersect(within) ? within : point;
  }

  void conclude(const SearchResult& found, PairVerdict& pair) const {
    switch (found.end) {
      case SearchEnd::apart:
        pair.verdict = MatrixVerdict::never;
        pair.reason = proven(pair.joint_boxes);
        break;
      case SearchEnd::near:
        pair.verdict = MatrixVerdict::can;
        pair.reason = "intersect at the witness";
        pair.witness = space_.variables_at(within_limits(deepened(space_, found.point)));
        break;
      case SearchEnd::unresolved: {
        pair.verdict = MatrixVerdict::undecided;
        const double doubt = (options_.slack + options_.resolution) * cell_;
        pair.reason = concat("not found to intersect, but less than ", metres(doubt, 2), " apart");
        break;
      }
      case SearchEnd::cut_off:
        pair.verdict = MatrixVerdict::undecided;
        pair.reason =
            concat("neither proven nor found to intersect after ", counted_boxes(pair.joint_boxes),
                   options_.is_late() ? ", when its time was up" : "");
        break;
    }
  }

  const Model& model_;
  PairSpace space_;
  double cell_;
  MatrixOptions options_;
};

/// A call of decide_pairs().
struct Matrix {
  const Model& model;
  const std::vector<WholeMesh>& meshes;
  const std::vector<JointZone>& zones;
  const Reaches& reaches;
  double cell;
  const MatrixOptions& options;

  PairVerdict decide(std::size_t a, std::size_t b, const Deadline& deadline) const {
    PairVerdict pair = {a, b, MatrixVerdict::undecided, "", {}, 0};
    MatrixOptions own = options;
    own.deadline = deadline;
    const JointZone* const zone = find_pair(zones, a, b);
    if (zone == nullptr) {
      decide(meshes[a], meshes[b], own, pair);
      return pair;
    }
    pair.zone = static_cast<std::size_t>(zone - zones.data());
    decide_outside(*zone, own, pair);
    pair.reason =
        concat("outside ", radius_text(model, zone->shape.radius, zone->joint), ": ", pair.reason);
    return pair;
  }

  void decide(const WholeMesh& a, const WholeMesh& b, const MatrixOptions& own,
              PairVerdict& pair) const {
    Decider(model, {pair.a, a, &reaches[pair.a]}, {pair.b, b, &reaches[pair.b]}, cell, own)
        .decide(pair);
  }

  /// The worst verdict of all bodies.
  void decide_outside(const JointZone& zone, MatrixOptions& own, PairVerdict& pair) const {
    // Vertices at cuts are rounded again.
    own.slack += 2 * kDeviation;
    PairVerdict worst = pair;
    worst.verdict = MatrixVerdict::never;
    worst.reason = "nothing is there of one of them";
    for (const ZoneBodies& bodies : zone.bodies) {
      PairVerdict of = pair;
      of.stops = worst.stops;
      decide(bodies.a.view(), bodies.b.view(), own, of);
      const std::uint64_t joint_boxes = worst.joint_boxes + of.joint_boxes;
      const bool is_guarded = worst.is_guarded || of.is_guarded;
      const std::vector<bool> stops = of.stops;
      if (&bodies == zone.bodies.data() || rank_of(of.verdict) > rank_of(worst.verdict)) {
        worst = std::move(of);
      }
      worst.joint_boxes = joint_boxes;
      worst.is_guarded = is_guarded;
      worst.stops = stops;
    }
    pair = std::move(worst);
  }
};

/// A pair's share of the remaining time, as a multiple of an equal share: most pairs need less.
constexpr double kShareOfTime = 2;
/// For pairs with a zone: they are few and need little.
constexpr double kShareWithZone = 10;

/// Pairs with a joint zone first: with one joint between, they need little time; what stays
/// undecided is stored in parts.
std::vector<PairVerdict*> in_order(std::vector<PairVerdict>& verdicts,
                                   const std::vector<JointZone>& zones) {
  std::vector<PairVerdict*> order;
  order.reserve(verdicts.size());
  for (PairVerdict& pair : verdicts) {
    order.push_back(&pair);
  }
  std::stable_partition(order.begin(), order.end(), [&](const PairVerdict* pair) {
    return find_pair(zones, pair->a, pair->b) != nullptr;
  });
  return order;
}

}  // namespace

const char* name_of(MatrixVerdict verdict) {
  constexpr const char* kNames[] = {"never", "can", "undecided", "fixed", "believed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

const char* name_of(const PairVerdict& pair) {
  return pair.zone && pair.verdict == MatrixVerdict::never ? "never outside zone"
                                                           : name_of(pair.verdict);
}

double PairVerdict::share() const {
  const auto count = static_cast<double>(std::count(stops.begin(), stops.end(), true));
  return stops.empty() ? 0 : count / static_cast<double>(stops.size());
}

std::vector<PairVerdict> decide_pairs(const Model& model, const std::vector<WholeMesh>& meshes,
                                      const std::vector<JointZone>& zones, const Reaches& reaches,
                                      double cell, const MatrixOptions& options,
                                      const MatrixProgress& progress) {
  const Matrix matrix = {model, meshes, zones, reaches, cell, options};
  std::vector<PairVerdict> verdicts;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      verdicts.push_back({a, b, MatrixVerdict::undecided, "", {}, 0});
    }
  }
  std::mutex mutex;
  std::size_t decided = 0;
  const std::vector<PairVerdict*> order = in_order(verdicts, zones);
  for_each_in_parallel(order.size(), [&](std::size_t i) {
    const double share = i < zones.size() ? kShareWithZone : kShareOfTime;
    const Deadline turn = turn_of(options.deadline, order.size() - i, share);
    *order[i] = matrix.decide(order[i]->a, order[i]->b, turn);
    const std::lock_guard<std::mutex> lock(mutex);
    if (progress) {
      progress(++decided, verdicts.size());
    }
  });
  if (options.deadline.at) {
    std::vector<PairVerdict*> hard;
    std::copy_if(order.begin(), order.end(), std::back_inserter(hard),
                 [](const PairVerdict* pair) { return pair->verdict == MatrixVerdict::undecided; });
    for_each_in_parallel(hard.size(), [&](std::size_t i) {
      const Deadline turn = turn_of(options.deadline, hard.size() - i, 1);
      if (!turn.is_past()) {
        *hard[i] = matrix.decide(hard[i]->a, hard[i]->b, turn);
      }
    });
  }
  return verdicts;
}

TrianglePair<WholeMesh::Index> triangles_at(const Model& model,
                                            const std::vector<WholeMesh>& meshes, double cell,
                                            const PairVerdict& pair) {
  TrianglePair<WholeMesh::Index> found{};
  const Transform frame = frame_between(model, joints_between(model, pair.a, pair.b), pair.witness);
  (void)first_pair(meshes[pair.a], meshes[pair.b], pose_of(frame, cell), found);
  return found;
}

std::vector<std::vector<ZoneParts>> decide_parts(const Model& model,
                                                 const std::vector<JointZone>& zones, double cell,
                                                 const MatrixOptions& options,
                                                 std::vector<PairVerdict>& pairs) {
  std::vector<std::vector<ZoneParts>> parts(pairs.size());
  for_each_in_parallel(pairs.size(), [&](std::size_t i) {
    PairVerdict& pair = pairs[i];
    if (!pair.zone || !pair.is_guarded) {
      return;
    }
    parts[i] = zone_parts(model, zones[*pair.zone], cell, options);
    pair.bodies.clear();
    if (parts[i].empty()) {
      pair.is_guarded = false;
      pair.stops.clear();
      pair.verdict = MatrixVerdict::never;
      pair.reason += "; proven by triangles";
    }
  });
  return parts;
}

}  // namespace flashbvh::tool
