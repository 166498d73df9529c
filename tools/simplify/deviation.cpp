#include "simplify/deviation.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::simplify {
namespace {

/// Tests one vertex in so many first: it finds most meshes that deviate too far.
constexpr std::size_t kSampled = 16;
/// Deviations below this part of the limit need no tight bound.
constexpr double kFine = 1.0 / 32;
/// A part of a triangle smaller than this part of the wanted distance is not cut again.
constexpr double kSmallest = 1.0 / 4096;
/// A part that leaves a triangle by less than this part of the wanted distance is not cut there.
constexpr double kCut = 1.0 / 8;
/// The rounding of doubles in some tens of operations, as a part of the largest coordinate.
constexpr double kRounding = 0x1p-44;

class Certificate {
 public:
  Certificate(const NearestTriangle& coarse, const bake::SourceMesh& mesh, double limit,
              std::vector<CoveredPart>* parts)
      : coarse_(coarse),
        mesh_(mesh),
        parts_(parts),
        arithmetic_error_(arithmetic_error(mesh)),
        limit_(limit - arithmetic_error_) {}

  Deviation made() {
    std::uint32_t hint = 0;
    for (std::size_t i = 0; i < mesh_.vertices.size() && !is_refuted(); i += kSampled) {
      hint = look(mesh_.vertices[i], hint).place;
    }
    for (std::size_t i = 0; i < mesh_.triangles.size() && !is_refuted(); ++i) {
      hint = cover(triangle_of(mesh_, mesh_.triangles[i]), hint);
    }
    found_.most = is_refuted() ? HUGE_VAL : within_ + arithmetic_error_;
    return found_;
  }

 private:
  bool is_refuted() const { return is_refuted_ || found_.at_least > limit_; }

  /// The distance that all parts have to keep, given the points tested so far.
  double wanted() const {
    return parts_ != nullptr
               ? limit_
               : std::min(std::max(kTightness * found_.at_least, kFine * limit_), limit_);
  }

  NearestTriangle::Found look(const Point& p, std::uint32_t hint) {
    const NearestTriangle::Found nearest = coarse_.to(p, hint);
    const double distance = std::sqrt(nearest.squared);
    if (distance > found_.at_least) {
      found_.at_least = distance;
      found_.where = p;
    }
    return nearest;
  }

  /// A bound on the distance of a part's points from a coarse triangle.
  double farthest(const PointTriangle& part, std::uint32_t place) const {
    double squared = 0;
    for (const Point& corner : part) {
      squared = std::max(squared, squared_distance(corner, coarse_.triangle(place)));
    }
    return std::sqrt(squared);
  }

  /// Returns the place of a coarse triangle near the part.
  std::uint32_t cover(const PointTriangle& part, std::uint32_t hint) {
    const double by_hint = farthest(part, hint);
    if (by_hint <= wanted()) {
      add(part, by_hint, hint);
      return hint;
    }
    const Point centre = centre_of(part);
    const double radius = radius_of(part, centre);
    const NearestTriangle::Found nearest = look(centre, hint);
    const double bound =
        std::min({by_hint, farthest(part, nearest.place), std::sqrt(nearest.squared) + radius});
    if (bound <= wanted() || radius <= kSmallest * wanted() || is_refuted()) {
      add(part, bound, bound == by_hint ? hint : nearest.place);
      return nearest.place;
    }
    std::uint32_t place = nearest.place;
    for (const PointTriangle& piece : cut(part, coarse_.triangle(place), kCut * wanted())) {
      place = cover(piece, place);
    }
    return nearest.place;
  }

  void add(const PointTriangle& part, double bound, std::uint32_t by) {
    is_refuted_ = is_refuted_ || bound > limit_;
    within_ = std::max(within_, bound);
    if (parts_ != nullptr) {
      parts_->push_back({part, by});
    }
  }

  const NearestTriangle& coarse_;
  const bake::SourceMesh& mesh_;
  std::vector<CoveredPart>* parts_;
  double arithmetic_error_;
  double limit_;
  double within_ = 0;
  bool is_refuted_ = false;
  Deviation found_;
};

/// Certifies again far below the limit, where the bound is not tight.
template <class Within>
Deviation tightened(const Within& within, double limit) {
  Deviation found = within(limit);
  while (found.most < kFine * limit) {
    limit = found.most;
    const Deviation finer = within(limit);
    found = finer.most <= found.most ? finer : found;
  }
  return found;
}

}  // namespace

double arithmetic_error(const bake::SourceMesh& mesh) {
  double most = 0;
  for (const Point& vertex : mesh.vertices) {
    for (const double coordinate : vertex) {
      most = std::max(most, std::fabs(coordinate));
    }
  }
  return kRounding * most;
}

Deviation deviation_from(const NearestTriangle& coarse, const bake::SourceMesh& mesh, double limit,
                         std::vector<CoveredPart>* parts) {
  return Certificate(coarse, mesh, limit, parts).made();
}

Deviation deviation_between(const bake::SourceMesh& mesh, const bake::SourceMesh& coarse,
                            double limit) {
  const NearestTriangle to_mesh(mesh);
  const NearestTriangle to_coarse(coarse);
  const auto within = [&](double most) {
    const Deviation of_mesh = deviation_from(to_coarse, mesh, most);
    const Deviation of_coarse = deviation_from(to_mesh, coarse, most);
    return of_coarse.most > of_mesh.most ? of_coarse : of_mesh;
  };
  return tightened(within, limit);
}

double farthest_from(const bake::SourceMesh& kept, const bake::SourceMesh& mesh) {
  const NearestTriangle to_kept(kept);
  const Point centre = kept.vertices[kept.triangles[0][0]];
  double farthest = 0;
  for (const Point& vertex : mesh.vertices) {
    const Point off = minus(vertex, centre);
    farthest = std::max(farthest, std::sqrt(dot(off, off)));
  }
  const double error = arithmetic_error(kept) + arithmetic_error(mesh);
  const auto within = [&](double limit) { return deviation_from(to_kept, mesh, limit); };
  return tightened(within, 2 * farthest + kErrors * error).most + error;
}

}  // namespace flashbvh::simplify
