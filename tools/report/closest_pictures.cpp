#include "report/closest_pictures.hpp"

#include <cstring>

#include "evaluate/poses.hpp"
#include "report/figure.hpp"
#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::int64_t kClosestSide = 720;

struct Moment {
  Scene scene;
  std::vector<LatticePoint> points;  ///< of all that is seen
  std::vector<LatticePoint> lit;
};

void add_link(const PostMesh& mesh, const Pose& pose, Paint paint, const std::uint16_t* lit,
              Moment& moment) {
  const std::vector<LatticePoint> points =
      transformed_vertices(AnyTree(LevelledPostMesh{mesh, nullptr, nullptr}), pose);
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& triangle = mesh.triangles[i];
    const std::array<LatticePoint, 3> corners = {
        points[triangle.corner[0]], points[triangle.corner[1]], points[triangle.corner[2]]};
    const bool is_lit = lit != nullptr && i == *lit;
    moment.scene.faces.push_back({corners, is_lit ? kIntersected : paint});
    if (is_lit) {
      moment.lit.insert(moment.lit.end(), corners.begin(), corners.end());
    }
  }
  moment.points.insert(moment.points.end(), points.begin(), points.end());
}

/// `all`: links besides the two.
Moment moment_of(const GuardedTrajectory& guarded, const ClosestMoment& closest, bool all) {
  const RobotPair& pair = guarded.robot.pairs[closest.pair];
  const std::vector<Pose> poses =
      link_poses(guarded.robot, guarded.trajectory.values(closest.period));
  Moment moment;
  for (std::uint8_t link = 0; link < guarded.robot.link_count; ++link) {
    const bool is_a = link == pair.a;
    if (all || is_a || link == pair.b) {
      const std::uint16_t* const lit = is_a             ? &closest.clearance.witness.a
                                       : link == pair.b ? &closest.clearance.witness.b
                                                        : nullptr;
      add_link(guarded.robot.meshes[link], poses[link], link == pair.b ? kSecondMesh : kFirstMesh,
               lit, moment);
    }
  }
  return moment;
}

/// Round what is lit, which may be small or hidden.
std::string circle_round(const Moment& moment, const View& view, const Frame& frame) {
  const Bounds lit = bounds_of(moment.lit);
  const Projection projection(view, frame, kDrawingSide);
  const Projected low = projection.project(lit.lower);
  const Projected high = projection.project(lit.upper);
  const std::int64_t x = high.x - low.x;
  const std::int64_t y = high.y - low.y;
  return concat("<circle cx=", (low.x + high.x) / 2, " cy=", (low.y + high.y) / 2,
                " r=", square_root(x * x + y * y) / 2 + 30, "></circle>\n");
}

/// From the corner that shows most of what is lit.
std::string picture(const GuardedTrajectory& guarded, const Moment& moment, const char* caption) {
  const Frame frame = frame_of(moment.points, corner_views());
  const View* best = nullptr;
  Drawn shown;
  for (const View& view : corner_views()) {
    Drawn next = draw(moment.scene, view, frame, kClosestSide);
    if (best == nullptr || next.seen[kIntersected] > shown.seen[kIntersected]) {
      best = &view;
      shown = std::move(next);
    }
  }
  double cell = 0;
  std::memcpy(&cell, &guarded.robot.cell_bits, sizeof cell);
  return figure(shown, *best, frame, {cell, " m"}, caption, circle_round(moment, *best, frame),
                caption);
}

std::string values_of(const GuardedTrajectory& guarded, std::size_t period) {
  std::string text;
  for (std::size_t i = 0; i < guarded.model.variables.size(); ++i) {
    text +=
        concat(i == 0 ? "" : ", ", escaped(guarded.model.joints[guarded.model.variables[i]].name),
               " ", significant(static_cast<double>(guarded.trajectory.values(period)[i]), 6));
  }
  return text;
}

}  // namespace

std::string closest_pictures(const GuardedTrajectory& guarded, const ClosestMoment& closest) {
  const RobotPair& pair = guarded.robot.pairs[closest.pair];
  return "<p class=keys><i class=\"key paint0\"></i>" + escaped(guarded.model.links[pair.a].name) +
         ", other links <i class=\"key paint1\"></i>" + escaped(guarded.model.links[pair.b].name) +
         " <i class=\"key paint2\"></i>the triangles that are nearest</p>\n<div class=contacts>\n" +
         picture(guarded, moment_of(guarded, closest, true), "The robot") +
         picture(guarded, moment_of(guarded, closest, false), "The two links") +
         "</div>\n<p class=note>Joints: <code>" + values_of(guarded, closest.period) +
         "</code></p>\n";
}

}  // namespace flashbvh::tool
