#include "robot/swept_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bake/quantise.hpp"
#include "flashbvh/solid.hpp"
#include "image/baking.hpp"
#include "robot/pair_search.hpp"
#include "robot/pair_space.hpp"
#include "robot/reaches.hpp"
#include "robot/revolution.hpp"

namespace flashbvh::tool {
namespace {

/// A part of Options::most_cells is all that a proof may take that may not work.
constexpr std::uint64_t kShare = 4;
/// Angles below this are not worth it, in radians.
constexpr double kSmallTurn = 0.5;

using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

/// A joint next to a link, on the way to the other one.
struct End {
  std::size_t link;
  std::size_t joint;
  Transform axis;  ///< in the link's frame
};

/// None if the link's solid of revolution does not do away with a variable.
std::optional<End> end_of(const Model& model, std::size_t link, std::size_t other) {
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
  return End{link, path.front(), joints.of_a.empty() ? first.fixed : Transform()};
}

/// The model with solids for links, and the joints about which they turn held.
struct SweptPair {
  Model model;
  double cell;
  Baked a;
  Baked b;
};

Baked baked(const bake::SourceMesh& mesh, double cell) {
  InputMesh input;
  input.mesh = mesh;
  BakeOptions options;
  options.cell = cell;
  return std::get<Baked>(bake(input, options).tree);
}

/// With the finest cell, of those twice and twice as large, that takes the solids.
SweptPair swept_pair(const Model& model, std::size_t a, std::size_t b, double cell,
                     const std::vector<End>& ends) {
  for (;; cell *= 2) {
    Model swept = model;
    for (const End& end : ends) {
      bake::SourceMesh& mesh = swept.links[end.link].mesh;
      // For what the link is rounded, and the solid.
      mesh = revolved(mesh, end.axis, 2 * kDeviation * cell);
      ModelJoint& held = swept.joints[swept.variables[model.joints[end.joint].variable]];
      held.lower = held.upper = held.lower + (held.upper - held.lower) / 2;
    }
    const bake::SourceMesh& mesh_a = swept.links[a].mesh;
    const bake::SourceMesh& mesh_b = swept.links[b].mesh;
    if (bake::fits(mesh_a, cell) && bake::fits(mesh_b, cell)) {
      return {swept, cell, baked(mesh_a, cell), baked(mesh_b, cell)};
    }
  }
}

/// Whether any part of `other`, which lies at `frame` and has no point in common with the solid's
/// surface, lies in the solid.
bool is_any_inside(const PostMesh& solid, const PostMesh& other, const Transform& frame,
                   double cell) {
  for (std::uint32_t i = 0; i < other.shell_count; ++i) {
    const Vertex& v = other.vertices[other.shell_vertices[i]];
    const Vector3 point =
        placed(frame, {cell * (v.x + other.origin[0]), cell * (v.y + other.origin[1]),
                       cell * (v.z + other.origin[2])});
    const auto cells = [&](std::size_t axis) {
      return static_cast<std::int32_t>(std::round(point[axis] / cell));
    };
    if (inside(solid, {cells(0), cells(1), cells(2)}).side != PointSide::outside) {
      return true;
    }
  }
  return false;
}

/// Surfaces that meet nowhere in a box of values keep the side of each other that they have at any
/// place of it.
bool is_proven(const SweptPair& pair, std::size_t a, std::size_t b, const std::vector<End>& ends,
               const MatrixOptions& options, const std::function<void(double)>& progress,
               std::uint64_t& cells, double distance) {
  const PostMesh mesh_a = pair.a.view();
  const PostMesh mesh_b = pair.b.view();
  const std::vector<double> reaches_a = reaches_of(pair.model, a, pair.cell);
  const std::vector<double> reaches_b = reaches_of(pair.model, b, pair.cell);
  const PairSpace space(pair.model, {a, &mesh_a, &reaches_a}, {b, &mesh_b, &reaches_b}, pair.cell);
  const SearchResult found = search_pair(space, options, progress, distance);
  cells += found.cells;
  if (found.end != SearchEnd::apart) {
    return false;
  }
  std::vector<double> middle;
  for (const Dimension& dimension : space.dimensions()) {
    middle.push_back(dimension.range.lower);
  }
  const Transform frame =
      frame_between(pair.model, joints_between(pair.model, a, b), space.variables_at(middle));
  return std::none_of(ends.begin(), ends.end(), [&](const End& end) {
    return end.link == a ? is_any_inside(mesh_a, mesh_b, frame, pair.cell)
                         : is_any_inside(mesh_b, mesh_a, inverse(frame), pair.cell);
  });
}

}  // namespace

bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, const std::function<void(double)>& progress,
                     std::uint64_t& cells, double distance) {
  const std::optional<End> end_a = end_of(model, a, b);
  const std::optional<End> end_b = end_of(model, b, a);
  std::vector<std::vector<End>> choices;
  if (end_a && end_b && end_a->joint != end_b->joint) {
    choices.push_back({*end_a, *end_b});
  }
  for (const std::optional<End>& end : {end_b, end_a}) {
    if (end) {
      choices.push_back({*end});
    }
  }
  MatrixOptions share = options;
  share.most_cells = options.most_cells / kShare;
  // The other link is rounded to the new lattice, and was to the old one.
  share.slack += 2 * kDeviation;
  return std::any_of(choices.begin(), choices.end(), [&](const std::vector<End>& ends) {
    const SweptPair pair = swept_pair(model, a, b, cell, ends);
    return is_proven(pair, a, b, ends, share, progress, cells, distance);
  });
}

}  // namespace flashbvh::tool
