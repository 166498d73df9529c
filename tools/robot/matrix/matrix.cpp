#include "robot/matrix/matrix.hpp"

#include <algorithm>

#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Cells that are looked at before a witness is searched for: most proofs take less.
constexpr std::uint64_t kFewCells = 4096;
/// Most for a proof that spares firmware a pair.
constexpr std::uint64_t kManyCells = 65536;
/// Places from which a witness is searched for.
constexpr std::uint32_t kStarts = 256;

std::string proven(std::uint64_t cells) {
  return concat("proven for all values within the limits, ", cells,
                cells == 1 ? " cell" : " cells");
}

class Decider {
 public:
  Decider(const Model& model, const std::vector<Mesh>& meshes, double cell,
          const MatrixOptions& options)
      : model_(model), meshes_(meshes), cell_(cell), options_(options) {
    for (std::size_t link = 0; link < model.links.size(); ++link) {
      reaches_.push_back(reaches_of(model, link, cell));
    }
  }

  PairVerdict decide(std::size_t a, std::size_t b,
                     const std::function<void(double)>& progress) const {
    PairVerdict pair = {a, b, MatrixVerdict::always, "", {}, 0};
    const PairSpace space(model_, {a, &meshes_[a], &reaches_[a]}, {b, &meshes_[b], &reaches_[b]},
                          cell_);
    if (space.dimensions().empty()) {
      pair.verdict = MatrixVerdict::fixed;
      pair.reason = concat("no joint moves them, ", space.intersect({}) ? "intersecting" : "apart");
      return pair;
    }
    pair.reason = why_always(space, a, b);
    if (pair.reason.empty()) {
      search(space, progress, pair);
      if (!is_left_out(pair)) {
        guard(space, progress, pair);
      }
    }
    return pair;
  }

 private:
  /// Null if the usual ones hold.
  const StopDistance* own_distances(std::size_t a, std::size_t b) const {
    return find_pair(options_.stops, a, b);
  }

  /// Empty if the pair has to be decided.
  std::string why_always(const PairSpace& space, std::size_t a, std::size_t b) const {
    if (!are_neighbours(a, b) || options_.looks == 0 || own_distances(a, b) != nullptr ||
        !intersect_wherever_tried(space, options_.looks)) {
      return "";
    }
    return concat("neighbours that intersect at each of ", options_.looks,
                  " configurations spread over the limits; sampled, not proven");
  }

  bool are_neighbours(std::size_t a, std::size_t b) const {
    return std::any_of(model_.neighbours.begin(), model_.neighbours.end(), [&](const auto& pair) {
      return std::minmax(pair.first, pair.second) == std::minmax(a, b);
    });
  }

  /// Whether the SRDF keeps a pair that is decided from being guarded.
  bool is_left_out(PairVerdict& pair) const {
    const DisabledPair* const disabled = find_pair(model_.disabled, pair.a, pair.b);
    if (disabled == nullptr) {
      return false;
    }
    if (pair.verdict == MatrixVerdict::never) {
      return own_distances(pair.a, pair.b) == nullptr;
    }
    if (disabled->is_believed) {
      pair.verdict = MatrixVerdict::believed;
      pair.reason += "; disabled in the SRDF and believed";
    } else if (pair.verdict == MatrixVerdict::undecided) {
      pair.reason += "; disabled in the SRDF, guarded all the same";
    }
    return disabled->is_believed;
  }

  /// Whether a guard has to look at the pair, and what it would say.
  void guard(const PairSpace& space, const std::function<void(double)>& progress,
             PairVerdict& pair) const {
    const StopDistance* const own = own_distances(pair.a, pair.b);
    const double stop = own != nullptr ? own->stop : options_.stop;
    const double warn = own != nullptr ? own->warn : options_.warn;
    pair.is_guarded = true;
    if (pair.verdict == MatrixVerdict::never) {
      const std::uint64_t before = pair.cells;
      pair.is_guarded = stop > 0 && !stays_away(space, stop, progress, pair);
      pair.reason += stop > 0 ? concat("; ", pair.cells - before, " more for --stop") : "";
    }
    pair.is_stopped = pair.is_guarded && is_within(space, stop);
    pair.is_warned = pair.is_guarded && !pair.is_stopped && is_within(space, warn);
  }

  /// A few cells, then a witness, then all cells.
  void search(const PairSpace& space, const std::function<void(double)>& progress,
              PairVerdict& pair) const {
    MatrixOptions few = options_;
    few.most_cells = std::min(options_.most_cells, kFewCells);
    SearchResult found = search_pair(space, few, progress);
    pair.cells = found.cells;
    if (found.end == SearchEnd::cut_off || found.end == SearchEnd::unresolved) {
      if (auto point = find_intersection(space, kStarts)) {
        found.end = SearchEnd::near;
        found.point = std::move(*point);
      }
    }
    if (found.end == SearchEnd::cut_off && few.most_cells < options_.most_cells) {
      if (is_proven_swept(model_, pair.a, pair.b, cell_, options_, progress, pair.cells)) {
        pair.verdict = MatrixVerdict::never;
        pair.reason = proven(pair.cells) + ", by solids of revolution";
        return;
      }
      found = search_pair(space, options_, progress);
      pair.cells += found.cells;
    }
    conclude(space, found, pair);
  }

  /// Whether it is proven to stay farther apart than the stop distance; most proofs take few cells.
  bool stays_away(const PairSpace& space, double stop, const std::function<void(double)>& progress,
                  PairVerdict& pair) const {
    MatrixOptions few = options_;
    few.most_cells = std::min(options_.most_cells, kManyCells);
    const SearchResult found = search_pair(space, few, progress, stop);
    pair.cells += found.cells;
    return found.end == SearchEnd::apart ||
           (found.end == SearchEnd::cut_off &&
            is_proven_swept(model_, pair.a, pair.b, cell_, few, progress, pair.cells, stop));
  }

  bool is_within(const PairSpace& space, double distance) const {
    for (std::uint32_t i = 0; i < options_.looks; ++i) {
      if (space.are_apart(spread_point(space, i), distance + options_.slack)) {
        return false;
      }
    }
    return options_.looks != 0;
  }

  /// Ranges are a little wider than limits; a witness is so only where it has to be.
  std::vector<double> within_limits(const PairSpace& space,
                                    const std::vector<double>& point) const {
    std::vector<double> within = point;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const ModelJoint& joint = model_.joints[model_.variables[space.dimensions()[i].variable]];
      within[i] = std::clamp(point[i], joint.lower, joint.upper);
    }
    return space.intersect(within) ? within : point;
  }

  void conclude(const PairSpace& space, const SearchResult& found, PairVerdict& pair) const {
    switch (found.end) {
      case SearchEnd::apart:
        pair.verdict = MatrixVerdict::never;
        pair.reason = proven(pair.cells);
        break;
      case SearchEnd::near:
        pair.verdict = MatrixVerdict::can;
        pair.reason = "intersect at the witness";
        pair.witness = space.variables_at(within_limits(space, deepened(space, found.point)));
        break;
      case SearchEnd::unresolved: {
        pair.verdict = MatrixVerdict::undecided;
        const double doubt = (options_.slack + options_.resolution) * cell_;
        pair.reason =
            concat("not found to intersect, but less than ", significant(doubt, 2), " m apart");
        break;
      }
      case SearchEnd::cut_off:
        pair.verdict = MatrixVerdict::undecided;
        pair.reason = concat("neither proven nor found to intersect after ", pair.cells, " cells");
        break;
    }
  }

  const Model& model_;
  const std::vector<Mesh>& meshes_;
  double cell_;
  const MatrixOptions& options_;
  std::vector<std::vector<double>> reaches_;
};

}  // namespace

const char* name_of(MatrixVerdict verdict) {
  constexpr const char* kNames[] = {"never", "can", "always", "undecided", "fixed", "believed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::vector<PairVerdict> decide_pairs(const Model& model, const std::vector<Mesh>& meshes,
                                      double cell, const MatrixOptions& options,
                                      const MatrixProgress& progress) {
  const Decider decider(model, meshes, cell, options);
  const std::size_t links = model.links.size();
  const std::size_t pairs = links * (links - 1) / 2;
  std::vector<PairVerdict> verdicts;
  for (std::size_t a = 0; a < links; ++a) {
    for (std::size_t b = a + 1; b < links; ++b) {
      const auto part = [&](double decided) {
        if (progress) {
          progress(verdicts.size(), pairs, decided);
        }
      };
      part(0);
      verdicts.push_back(decider.decide(a, b, part));
    }
  }
  return verdicts;
}

}  // namespace flashbvh::tool
