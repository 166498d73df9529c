#include "robot/matrix/swept_pair.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "bake/quantise.hpp"
#include "flashbvh/solid.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/read/primitive_mesh.hpp"

namespace flashbvh::tool {
namespace {

/// Distance of a cut from a height, in margins; more than the rounding of both.
constexpr double kBeside = 1.6;
/// Examines at most this many times the slabs allowed.
constexpr std::uint32_t kTries = 8;

/// The largest distance from z of a segment's part between two heights, or 0 if there is no such
/// part. The distance from a line is convex, so it is largest at an end.
double widest(const Vector3& p, const Vector3& q, double low, double high) {
  const double rise = q[2] - p[2];
  double from = 0;
  double to = 1;
  if (rise != 0) {
    const double one = (low - p[2]) / rise;
    const double other = (high - p[2]) / rise;
    from = std::max(0.0, std::min(one, other));
    to = std::min(1.0, std::max(one, other));
  } else if (p[2] < low || p[2] > high) {
    return 0;
  }
  if (from > to) {
    return 0;
  }
  const auto at = [&](double part) {
    return std::hypot(p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]));
  };
  return std::max(at(from), at(to));
}

/// For all triangles: a triangle's part between two heights has its corners on the edges.
double widest(const bake::SourceMesh& mesh, double low, double high) {
  double most = 0;
  for (const bake::TriangleCorners& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      most = std::max(most, widest(mesh.vertices[triangle[i]], mesh.vertices[triangle[(i + 1) % 3]],
                                   low, high));
    }
  }
  return most;
}

/// An interval of the axis, and the body's radius in it.
struct Slab {
  double low;
  double high;
  double radius;
};

/// Cuts a margin away from the heights of vertices, where a solid's width may jump, so that slabs
/// between heights exclude both. None if the mesh has too many heights.
std::vector<double> cuts_by_heights(const bake::SourceMesh& mesh, double margin, std::size_t most) {
  std::set<double> heights;
  for (const Vector3& vertex : mesh.vertices) {
    heights.insert(margin * std::round(vertex[2] / margin));
  }
  std::vector<double> cuts;
  if (2 * heights.size() <= most) {
    for (const double height : heights) {
      cuts.insert(cuts.end(), {height - kBeside * margin, height + kBeside * margin});
    }
  }
  return cuts;
}

std::vector<double> cuts_of(const bake::SourceMesh& mesh, double low, double high, double margin,
                            const Fineness& fineness) {
  std::vector<double> cuts;
  if (fineness.by_heights) {
    cuts = cuts_by_heights(mesh, margin, std::size_t{kTries} * fineness.slabs);
  }
  cuts.insert(cuts.end(), {low, high});
  for (std::uint32_t i = 1; i < fineness.slabs; ++i) {
    cuts.push_back(low + (high - low) * i / fineness.slabs);
  }
  for (double& cut : cuts) {
    cut = std::clamp(cut, low, high);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

std::vector<Slab> slabs_of(const bake::SourceMesh& mesh, const std::vector<double>& cuts,
                           double margin) {
  std::vector<Slab> slabs;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    slabs.push_back(
        {cuts[i - 1], cuts[i], widest(mesh, cuts[i - 1] - margin, cuts[i] + margin) + margin});
  }
  return slabs;
}

/// Merges neighbours of nearly equal width, to save triangles.
std::vector<Slab> merged(const std::vector<Slab>& slabs, double alike) {
  std::vector<Slab> kept;
  for (const Slab& slab : slabs) {
    if (!kept.empty() && std::fabs(kept.back().radius - slab.radius) < alike * slab.radius) {
      kept.back() = {kept.back().low, slab.high, std::max(kept.back().radius, slab.radius)};
    } else {
      kept.push_back(slab);
    }
  }
  return kept;
}

/// Merges slabs down to the number that the fineness allows.
std::vector<Slab> few(const std::vector<Slab>& slabs, const Fineness& fineness) {
  std::vector<Slab> kept = merged(slabs, fineness.alike);
  for (double alike = 2 * fineness.alike; kept.size() > fineness.slabs; alike *= 2) {
    kept = merged(slabs, alike);
  }
  return kept;
}

void add_ring(bake::SourceMesh& mesh, double radius, double z, std::uint32_t sides) {
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
}

/// Smaller ranges are not worth a solid, in radians.
constexpr double kSmallTurn = 0.5;

}  // namespace

bake::SourceMesh revolved(const bake::SourceMesh& mesh, const Transform& axis, double margin,
                          const Fineness& fineness) {
  bake::SourceMesh seen = mesh;
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (Vector3& vertex : seen.vertices) {
    vertex = placed(inverse(axis), vertex);
    low = std::min(low, vertex[2]);
    high = std::max(high, vertex[2]);
  }
  low -= margin;
  high += margin;
  bake::SourceMesh body;
  body.vertices.push_back({0, 0, low});
  const double wider = 1 / std::cos(kPi / fineness.sides);
  const std::vector<double> cuts = cuts_of(seen, low, high, margin, fineness);
  for (const Slab& slab : few(slabs_of(seen, cuts, margin), fineness)) {
    add_ring(body, slab.radius * wider, slab.low, fineness.sides);
    add_ring(body, slab.radius * wider, slab.high, fineness.sides);
  }
  body.vertices.push_back({0, 0, high});
  add_round_triangles(body, fineness.sides);
  for (Vector3& vertex : body.vertices) {
    vertex = placed(axis, vertex);
  }
  return body;
}

std::optional<SweptEnd> swept_end(const Model& model, std::size_t link, std::size_t other) {
  const JointsBetween joints = joints_between(model, link, other);
  std::vector<std::size_t> path = joints.of_a;
  path.insert(path.end(), joints.of_b.rbegin(), joints.of_b.rend());
  const ModelJoint& first = model.joints[path.front()];
  const auto uses = std::count_if(path.begin(), path.end(), [&](std::size_t joint) {
    return model.joints[joint].variable == first.variable;
  });
  const Interval range = range_of_joint(model, path.front());
  if (first.type == JointType::prismatic || uses > 1 || path.size() < 2 ||
      range.upper - range.lower < kSmallTurn) {
    return std::nullopt;
  }
  return SweptEnd{link, path.front(), joints.of_a.empty() ? first.fixed : Transform()};
}

SweptPair swept_pair(const Model& model, std::size_t a, std::size_t b, double cell,
                     const std::vector<SweptEnd>& ends, const Fineness& fineness) {
  for (;; cell *= 2) {
    Model swept = model;
    for (const SweptEnd& end : ends) {
      bake::SourceMesh& mesh = swept.links[end.link].mesh;
      // Covers the rounding of the link and of the solid.
      mesh = revolved(mesh, end.axis, 2 * kDeviation * cell, fineness);
      ModelJoint& held = swept.joints[swept.variables[model.joints[end.joint].variable]];
      held.lower = held.upper = held.lower + (held.upper - held.lower) / 2;
    }
    const bake::SourceMesh& mesh_a = swept.links[a].mesh;
    const bake::SourceMesh& mesh_b = swept.links[b].mesh;
    if (bake::fits(bake::extent_of(mesh_a), cell) && bake::fits(bake::extent_of(mesh_b), cell)) {
      return {swept, a, b, cell, bake_part(mesh_a, cell), bake_part(mesh_b, cell)};
    }
  }
}

bool is_any_inside(const SweptPair& pair, const SweptEnd& end,
                   const std::vector<double>& variables) {
  const bool is_a = end.link == pair.link_a;
  const WholeMesh solid = (is_a ? pair.a : pair.b).view();
  const WholeMesh other = (is_a ? pair.b : pair.a).view();
  const JointsBetween joints =
      joints_between(pair.model, end.link, is_a ? pair.link_b : pair.link_a);
  const Transform frame = frame_between(pair.model, joints, variables);
  for (std::uint32_t i = 0; i < other.shell_count; ++i) {
    const auto [x, y, z] = vertex_of(other, other.shell_vertices[i]);
    const Vector3 point = placed(frame, {pair.cell * x, pair.cell * y, pair.cell * z});
    const auto cells = [&](std::size_t axis) {
      return static_cast<std::int32_t>(std::round(point[axis] / pair.cell));
    };
    if (inside(solid, {cells(0), cells(1), cells(2)}).side != PointSide::outside) {
      return true;
    }
  }
  return false;
}

}  // namespace flashbvh::tool
