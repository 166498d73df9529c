#include "simplify/collapse.hpp"
#include "bake/length.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flashbvh::simplify {
namespace {

/// Parts smaller than this part of the limit are not cut again.
constexpr double kSmallestCut = 1.0 / 8;
constexpr std::uint32_t kNone = 0xFFFFFFFF;
/// Part of the planes' weight: keeps a vertex in its place in directions that planes leave free.
constexpr double kRegularisation = 1e-4;
/// The farthest motion of a vertex, as a multiple of the collapsing edge.
constexpr double kFarthestEdges = 1.5;

/// Sum of squared distances from planes, weighted by the triangles' areas.
struct Quadric {
  std::array<double, 10> sums{};

  void add(const Point& normal, double offset, double weight) {
    const std::array<double, 4> plane = {normal[0], normal[1], normal[2], offset};
    std::size_t place = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        sums[place++] += weight * plane[i] * plane[j] * (i == j ? 1 : 2);
      }
    }
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += other.sums[i];
    }
  }
  /// The point of the least sum; near `middle` in directions on which the sum hardly depends.
  Point least_near(const Point& middle) const {
    const double weight = kRegularisation * (sums[0] + sums[4] + sums[7]);
    const std::array<Point, 3> rows = {{{sums[0] + weight, sums[1] / 2, sums[2] / 2},
                                        {sums[1] / 2, sums[4] + weight, sums[5] / 2},
                                        {sums[2] / 2, sums[5] / 2, sums[7] + weight}}};
    const Point right = {weight * middle[0] - sums[3] / 2, weight * middle[1] - sums[6] / 2,
                         weight * middle[2] - sums[8] / 2};
    const Point minors = cross(rows[1], rows[2]);
    const double determinant = dot(rows[0], minors);
    if (!(determinant > 0)) {
      return middle;
    }
    const Point second = cross(rows[2], rows[0]);
    const Point third = cross(rows[0], rows[1]);
    Point at{};
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = (right[0] * minors[i] + right[1] * second[i] + right[2] * third[i]) / determinant;
    }
    return at;
  }
  double at(const Point& p) const {
    const std::array<double, 4> point = {p[0], p[1], p[2], 1};
    double sum = 0;
    std::size_t place = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        sum += sums[place++] * point[i] * point[j];
      }
    }
    return sum;
  }
};

using Numbers = std::vector<std::uint32_t>;

class Collapser {
 public:
  Collapser(bake::SourceMesh& mesh, const std::vector<CoveredPart>& parts,
            const NearestTriangle& original, double cell, double limit,
            std::vector<bool>& is_changed, const tool::Deadline& deadline)
      : mesh_(mesh),
        is_changed_(is_changed),
        deadline_(deadline),
        original_(original),
        cell_(cell),
        limit_(limit),
        squared_(limit * limit),
        around_(mesh.vertices.size()),
        quadrics_(mesh.vertices.size()),
        parts_(mesh.triangles.size()),
        is_gone_(mesh.triangles.size(), false) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      for (const std::uint32_t corner : mesh.triangles[i]) {
        if (around_[corner].empty() || around_[corner].back() != i) {
          around_[corner].push_back(i);
        }
      }
      add_quadric(i);
    }
    for (const CoveredPart& part : parts) {
      parts_[part.by].push_back(part.part);
    }
    std::uint32_t hint = 0;
    for (const Point& vertex : mesh.vertices) {
      box_.add(vertex);
      hint = original.to(vertex, hint).place;
      hints_.push_back(hint);
    }
  }

  std::size_t run() {
    const std::size_t gone = collapse_all();
    std::vector<bake::TriangleCorners> kept;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!is_gone_[i]) {
        kept.push_back(mesh_.triangles[i]);
      }
    }
    mesh_.triangles = std::move(kept);
    return gone;
  }

 private:
  struct Order {
    double cost;
    std::uint32_t from;
    std::uint32_t to;
  };

  void add_quadric(std::uint32_t triangle) {
    const PointTriangle at = triangle_of(mesh_, mesh_.triangles[triangle]);
    Point normal = cross(minus(at[1], at[0]), minus(at[2], at[0]));
    const double length = bake::length(normal[0], normal[1], normal[2]);
    if (length == 0) {
      return;
    }
    for (double& coordinate : normal) {
      coordinate /= length;
    }
    for (const std::uint32_t corner : mesh_.triangles[triangle]) {
      quadrics_[corner].add(normal, -dot(normal, at[0]), length);
    }
  }

  Numbers neighbours(std::uint32_t vertex) const {
    Numbers found;
    for (const std::uint32_t triangle : around_[vertex]) {
      for (const std::uint32_t corner : mesh_.triangles[triangle]) {
        if (corner != vertex && std::find(found.begin(), found.end(), corner) == found.end()) {
          found.push_back(corner);
        }
      }
    }
    return found;
  }

  /// Tries each vertex whose surroundings have not changed in this pass. Returns the collapses.
  std::size_t collapse_all() {
    std::vector<Order> orders;
    for (std::uint32_t from = 0; from < around_.size(); ++from) {
      for (const std::uint32_t to : neighbours(from)) {
        if (is_changed_[from] || is_changed_[to]) {
          const Point at = nearest_to_planes(from, to);
          orders.push_back({quadrics_[from].at(at) + quadrics_[to].at(at), from, to});
        }
      }
    }
    std::sort(orders.begin(), orders.end(), [](const Order& a, const Order& b) {
      return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
    });
    std::vector<bool> is_touched(around_.size(), false);
    std::size_t gone = 0;
    for (const Order& order : orders) {
      if (deadline_.is_past()) {
        break;
      }
      if (is_touched[order.from] || is_touched[order.to] || !collapse(order.from, order.to)) {
        continue;
      }
      ++gone;
      is_touched[order.from] = true;
      is_touched[order.to] = true;
      for (const std::uint32_t triangle : around_[order.to]) {
        for (const std::uint32_t corner : mesh_.triangles[triangle]) {
          is_touched[corner] = true;
        }
      }
    }
    is_changed_ = std::move(is_touched);
    return gone;
  }

  static bool has(const bake::TriangleCorners& corners, std::uint32_t vertex) {
    return std::find(corners.begin(), corners.end(), vertex) != corners.end();
  }

  /// True if no point of the triangle is farther from the original than the limit. `hint`: the
  /// triangle to test first.
  bool is_near_original(const PointTriangle& at, std::uint32_t& hint) const {
    if (is_covered_by(original_.triangle(hint), at)) {
      return true;
    }
    const Point centre = centre_of(at);
    const NearestTriangle::Found nearest = original_.to(centre, hint);
    hint = nearest.place;
    if (nearest.squared > squared_) {
      return false;
    }
    const double radius = radius_of(at, centre);
    if (is_covered_by(original_.triangle(hint), at) ||
        std::sqrt(nearest.squared) + radius <= limit_) {
      return true;
    }
    if (radius <= kSmallestCut * limit_) {
      return false;
    }
    for (const PointTriangle& piece : cut(at, original_.triangle(hint), kSmallestCut * limit_)) {
      std::uint32_t place = hint;
      if (!is_near_original(piece, place)) {
        return false;
      }
    }
    return true;
  }

  bool is_covered_by(const PointTriangle& triangle, const PointTriangle& part) const {
    return std::all_of(part.begin(), part.end(), [&](const Point& corner) {
      return squared_distance(corner, triangle) <= squared_;
    });
  }

  /// Collapses to the point nearest to both vertices' planes, or else to `to`.
  bool collapse(std::uint32_t from, std::uint32_t to) {
    const Point best = on_lattice(nearest_to_planes(from, to));
    return collapse(from, to, best) ||
           (best != mesh_.vertices[to] && collapse(from, to, mesh_.vertices[to]));
  }

  bool collapse(std::uint32_t from, std::uint32_t to, const Point& at) {
    const bool moves = at != mesh_.vertices[to];
    candidates_.clear();
    add_candidates(from, to, at);
    const std::size_t of_from = candidates_.size();
    add_candidates(to, from, at);
    const std::size_t changed = moves ? candidates_.size() : of_from;
    covered_.clear();
    if (candidates_.empty() || !cover_all(around_[from], kNone) ||
        (moves && !cover_all(around_[to], from))) {
      return false;
    }
    for (std::size_t i = 0; i < changed; ++i) {
      std::uint32_t hint = hints_[to];
      if (!is_near_original(candidates_[i].at, hint)) {
        return false;
      }
    }
    if (moves) {
      mesh_.vertices[to] = at;
      for (const std::uint32_t triangle : around_[to]) {
        parts_[triangle].clear();
      }
    }
    apply(from, to);
    return true;
  }

  /// Adds the triangles of `vertex` without `other`, with `vertex` at `at`.
  void add_candidates(std::uint32_t vertex, std::uint32_t other, const Point& at) {
    for (const std::uint32_t triangle : around_[vertex]) {
      const bake::TriangleCorners& corners = mesh_.triangles[triangle];
      if (has(corners, other)) {
        continue;
      }
      PointTriangle placed = triangle_of(mesh_, corners);
      for (std::size_t i = 0; i < 3; ++i) {
        placed[i] = corners[i] == vertex ? at : placed[i];
      }
      candidates_.push_back({triangle, placed});
    }
  }

  /// Covers all that these triangles cover, except triangles with a corner `but`.
  bool cover_all(const Numbers& triangles, std::uint32_t but) {
    return std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t triangle) {
      return has(mesh_.triangles[triangle], but) ||
             std::all_of(parts_[triangle].begin(), parts_[triangle].end(),
                         [&](const PointTriangle& part) { return cover(part); });
    });
  }

  Point nearest_to_planes(std::uint32_t from, std::uint32_t to) const {
    Quadric sum = quadrics_[from];
    sum.add(quadrics_[to]);
    Point middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle[axis] = (mesh_.vertices[from][axis] + mesh_.vertices[to][axis]) / 2;
    }
    const Point edge = minus(mesh_.vertices[from], mesh_.vertices[to]);
    const Point best = sum.least_near(middle);
    const Point off = minus(best, middle);
    const bool is_near = bake::length(off[0], off[1], off[2]) <=
                         kFarthestEdges * bake::length(edge[0], edge[1], edge[2]);
    return is_near ? best : mesh_.vertices[to];
  }

  /// Rounds to the lattice and clamps to the mesh's box, so that the mesh still fits the lattice.
  Point on_lattice(const Point& p) const {
    Point at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      at[axis] = std::clamp(std::round(p[axis] / cell_) * cell_, box_.low[axis], box_.high[axis]);
    }
    return at;
  }

  /// True if each piece of the part is within the limit of one candidate.
  bool cover(const PointTriangle& part) {
    for (const Candidate& candidate : candidates_) {
      if (is_covered_by(candidate.at, part)) {
        covered_.push_back({part, candidate.triangle});
        return true;
      }
    }
    const Point centre = centre_of(part);
    const Candidate* nearest = nullptr;
    double least = HUGE_VAL;
    for (const Candidate& candidate : candidates_) {
      const double squared = squared_distance(centre, candidate.at);
      if (squared < least) {
        least = squared;
        nearest = &candidate;
      }
    }
    if (least > squared_ || radius_of(part, centre) <= kSmallestCut * limit_) {
      return false;
    }
    const std::vector<PointTriangle> pieces = cut(part, nearest->at, kSmallestCut * limit_);
    return std::all_of(pieces.begin(), pieces.end(),
                       [&](const PointTriangle& piece) { return cover(piece); });
  }

  void apply(std::uint32_t from, std::uint32_t to) {
    for (const std::uint32_t triangle : around_[from]) {
      parts_[triangle].clear();
      bake::TriangleCorners& corners = mesh_.triangles[triangle];
      if (!has(corners, to)) {
        std::replace(corners.begin(), corners.end(), from, to);
        around_[to].push_back(triangle);
        continue;
      }
      is_gone_[triangle] = true;
      for (const std::uint32_t corner : corners) {
        if (corner != from) {
          Numbers& there = around_[corner];
          there.erase(std::remove(there.begin(), there.end(), triangle), there.end());
        }
      }
    }
    around_[from].clear();
    quadrics_[to].add(quadrics_[from]);
    for (const CoveredPart& part : covered_) {
      parts_[part.by].push_back(part.part);
    }
  }

  struct Candidate {
    std::uint32_t triangle;
    PointTriangle at;
  };

  bake::SourceMesh& mesh_;
  std::vector<bool>& is_changed_;
  const tool::Deadline& deadline_;
  const NearestTriangle& original_;
  double cell_;
  double limit_;
  double squared_;
  Box box_;                      ///< of the mesh
  std::vector<Numbers> around_;  ///< triangles of each vertex
  std::vector<Quadric> quadrics_;
  std::vector<std::vector<PointTriangle>> parts_;  ///< parts that each triangle covers
  std::vector<bool> is_gone_;
  Numbers hints_;  ///< for each vertex, a triangle of the original near it
  std::vector<Candidate> candidates_;
  std::vector<CoveredPart> covered_;
};

}  // namespace

std::size_t collapse_edges(bake::SourceMesh& coarse, const std::vector<CoveredPart>& parts,
                           const NearestTriangle& original, double cell, double limit,
                           std::vector<bool>& is_changed, const tool::Deadline& deadline) {
  return Collapser(coarse, parts, original, cell, limit, is_changed, deadline).run();
}

}  // namespace flashbvh::simplify
