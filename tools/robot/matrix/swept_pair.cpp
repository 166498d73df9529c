#include "robot/matrix/swept_pair.hpp"

#include <algorithm>
#include <cmath>

#include "bake/quantise.hpp"
#include "flashbvh/solid.hpp"
#include "image/baking.hpp"
#include "robot/matrix/reaches.hpp"

namespace flashbvh::tool {
namespace {

/// Angles below this are not worth it, in radians.
constexpr double kSmallTurn = 0.5;

SweptPair::Baked baked(const bake::SourceMesh& mesh, double cell) {
  InputMesh input;
  input.mesh = mesh;
  BakeOptions options;
  options.cell = cell;
  return std::get<SweptPair::Baked>(bake(input, options).tree);
}

}  // namespace

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
      // For what the link is rounded, and the solid.
      mesh = revolved(mesh, end.axis, 2 * kDeviation * cell, fineness);
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

bool is_any_inside(const Mesh& solid, const Mesh& other, const Transform& frame, double cell) {
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

}  // namespace flashbvh::tool
