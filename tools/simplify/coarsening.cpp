#include "simplify/coarsening.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "simplify/collapse.hpp"

namespace flashbvh::simplify {
namespace {

/// Factor of the simplifier's error from one proposal to the next finer one.
constexpr double kFiner = 0.6;
constexpr int kProposals = 6;
/// Most passes over all vertices.
constexpr int kPasses = 24;
/// A pass that removes less than this part of the triangles is the last one.
constexpr double kLastPass = 0.003;

bake::SourceMesh without_unused_vertices(const bake::SourceMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  return part_of(mesh, all);
}

/// The result of meshoptimizer for this error, which it may exceed.
bake::SourceMesh proposal(const bake::SourceMesh& mesh, double error) {
  std::vector<float> positions;
  for (const Point& vertex : mesh.vertices) {
    for (const double coordinate : vertex) {
      positions.push_back(static_cast<float>(coordinate));
    }
  }
  std::vector<unsigned> indices;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    indices.insert(indices.end(), corners.begin(), corners.end());
  }
  constexpr std::size_t stride = 3 * sizeof(float);
  const float scale = meshopt_simplifyScale(positions.data(), mesh.vertices.size(), stride);
  std::vector<unsigned> left(indices.size());
  left.resize(scale == 0 ? 0
                         : meshopt_simplify(left.data(), indices.data(), indices.size(),
                                            positions.data(), mesh.vertices.size(), stride, 0,
                                            static_cast<float>(error) / scale, 0, nullptr));
  bake::SourceMesh coarse;
  coarse.vertices = mesh.vertices;
  for (std::size_t i = 0; i + 2 < left.size(); i += 3) {
    coarse.triangles.push_back({left[i], left[i + 1], left[i + 2]});
  }
  return coarse;
}

/// Drops triangles with coinciding corners, except one for each edge or point that no other
/// triangle has.
void drop_collapsed(bake::SourceMesh& mesh) {
  const auto corner_count = [](const bake::TriangleCorners& corners) {
    const auto& [p, q, r] = corners;
    return 1 + (q != p ? 1 : 0) + (r != p && r != q ? 1 : 0);
  };
  std::vector<bake::TriangleCorners> all = mesh.triangles;
  std::stable_sort(all.begin(), all.end(),
                   [&](const auto& p, const auto& q) { return corner_count(p) > corner_count(q); });
  std::set<std::array<std::uint32_t, 2>> held;  // edges, and points as edges of no length
  mesh.triangles.clear();
  for (const bake::TriangleCorners& corners : all) {
    const std::size_t before = held.size();
    for (const std::uint32_t from : corners) {
      for (const std::uint32_t to : corners) {
        held.insert({from, to});
      }
    }
    if (corner_count(corners) == 3 || held.size() > before) {
      mesh.triangles.push_back(corners);
    }
  }
}

/// Drops repeated triangles unless that opens a closed mesh.
void drop_repeated(bake::SourceMesh& mesh) {
  std::map<bake::TriangleCorners, std::size_t> seen;
  std::vector<bake::TriangleCorners> kept;
  for (const bake::TriangleCorners& corners : mesh.triangles) {
    bake::TriangleCorners turned = corners;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    if (seen.emplace(turned, kept.size()).second) {
      kept.push_back(corners);
    }
  }
  if (bake::is_closed(kept) || !bake::is_closed(mesh.triangles)) {
    mesh.triangles = std::move(kept);
  }
}

}  // namespace

Coarsening::Coarsening(const bake::SourceMesh& mesh, double cell)
    : Coarsening(mesh, bake::round_to_lattice(mesh, bake::extent_of(mesh), cell)) {}

Coarsening::Coarsening(const bake::SourceMesh& mesh, bake::LatticeMesh rounded)
    : rounded_(std::make_shared<const bake::LatticeMesh>(std::move(rounded))) {
  const bake::SourceMesh placed = source_of(*rounded_);
  margin_ = kErrors * std::max(arithmetic_error(mesh), arithmetic_error(placed));
  std::map<std::uint32_t, std::vector<std::uint32_t>> shells;
  const std::vector<std::uint32_t> first =
      bake::shells_of(placed.triangles, placed.vertices.size());
  for (std::uint32_t i = 0; i < placed.triangles.size(); ++i) {
    shells[first[placed.triangles[i][0]]].push_back(i);
  }
  for (const auto& [vertex, numbers] : shells) {
    bake::SourceMesh original = part_of(mesh, numbers);
    bake::SourceMesh coarse = part_of(placed, numbers);
    drop_collapsed(coarse);
    NearestTriangle nearest(original);
    shells_.push_back({std::move(original), std::move(coarse), std::move(nearest)});
  }
}

bool Coarsening::is_within(const Shell& shell, const bake::SourceMesh& coarse, double limit) {
  return deviation_from(NearestTriangle(coarse), shell.original, limit).most <= limit &&
         deviation_from(shell.nearest, coarse, limit).most <= limit;
}

/// Takes the coarsest proposal that the certificate confirms, or keeps all triangles.
void Coarsening::propose(Shell& shell, double limit, const tool::Deadline& deadline) {
  double error = limit;
  for (int i = 0; i < kProposals && !deadline.is_past(); ++i) {
    bake::SourceMesh coarse = proposal(shell.coarse, error);
    if (!coarse.triangles.empty() &&
        bake::is_closed(coarse.triangles) == bake::is_closed(shell.coarse.triangles) &&
        is_within(shell, coarse, limit)) {
      shell.coarse = std::move(coarse);
      return;
    }
    error *= kFiner;
  }
}

/// Each pass covers the original again, so that pieces cut in earlier passes are joined again.
void Coarsening::collapse(Shell& shell, double limit, const tool::Deadline& deadline) const {
  std::vector<bool> is_changed(shell.coarse.vertices.size(), true);
  for (int pass = 0; pass < kPasses && !deadline.is_past(); ++pass) {
    const NearestTriangle nearest(shell.coarse);
    std::vector<CoveredPart> parts;
    if (deviation_from(nearest, shell.original, limit, &parts).most > limit) {
      return;  // rounding alone leaves hardly any distance
    }
    for (CoveredPart& part : parts) {
      part.by = nearest.number(part.by);
    }
    const std::size_t before = shell.coarse.triangles.size();
    const std::size_t gone = collapse_edges(shell.coarse, parts, shell.nearest, rounded_->cell,
                                            limit - margin_, is_changed, deadline);
    if (gone == 0 || static_cast<double>(gone) < kLastPass * static_cast<double>(before)) {
      return;
    }
  }
}

void Coarsening::coarsen(double limit, const tool::Deadline& deadline) {
  // deviation() has the larger arithmetic error of the whole mesh.
  const double of_shell = std::max(limit - margin_, 0.0);
  for (Shell& shell : shells_) {
    if (limit_ == 0) {
      propose(shell, of_shell, deadline);
      shell.coarse = without_unused_vertices(shell.coarse);
    }
  }
  for (Shell& shell : shells_) {
    collapse(shell, of_shell, deadline);
  }
  limit_ = limit;
  is_unfinished_ = deadline.is_past();
}

Deviation Coarsening::deviation() const {
  bake::SourceMesh original;
  for (const Shell& shell : shells_) {
    append(shell.original, original);
  }
  Deviation found = deviation_between(original, mesh(), limit_);
  if (found.at_least <= limit_) {
    found.most = std::min(found.most, limit_);  // the certificate gives up very near the limit
  }
  return found;
}

std::size_t Coarsening::estimate(double limit) const {
  std::size_t count = 0;
  for (const Shell& shell : shells_) {
    count += std::max<std::size_t>(proposal(shell.coarse, limit).triangles.size(), 1);
  }
  return count;
}

std::size_t Coarsening::triangle_count() const {
  std::size_t count = 0;
  for (const Shell& shell : shells_) {
    count += (is_original() ? shell.original : shell.coarse).triangles.size();
  }
  return count;
}

bake::SourceMesh Coarsening::mesh() const {
  bake::SourceMesh all;
  for (const Shell& shell : shells_) {
    bake::SourceMesh coarse = shell.coarse;
    drop_repeated(coarse);
    append(without_unused_vertices(coarse), all);
  }
  return all;
}

}  // namespace flashbvh::simplify
