#include "report/arm_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "evaluate/poses.hpp"
#include "flashbvh/clearance.hpp"
#include "report/figure.hpp"
#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::int64_t kPairSide = 720;
constexpr std::int64_t kArmSide = 480;
/// To choose a view, less is enough.
constexpr std::int64_t kTrialSide = 240;
/// Differences of corners that nearest_points_of() takes are below it.
constexpr std::int64_t kMostSpan = 1 << 17;

struct Drawing {
  Scene scene;
  std::vector<LatticePoint> points;  ///< of all that is seen
  std::vector<LatticePoint> lit;     ///< corners of a triangle of a's, then of one of b's
};

void add_link(const PosedArm& arm, std::size_t link, Paint paint, const std::uint16_t* lit,
              Drawing& drawing) {
  const PostMesh& mesh = arm.robot.meshes[link];
  const std::vector<LatticePoint> points =
      transformed_vertices(AnyTree(LevelledPostMesh{mesh, nullptr, nullptr}), arm.poses[link]);
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& corner = mesh.triangles[i].corner;
    const std::array<LatticePoint, 3> corners = {points[corner[0]], points[corner[1]],
                                                 points[corner[2]]};
    const bool is_lit = lit != nullptr && mesh.triangle_ids[i] == *lit;
    drawing.scene.faces.push_back({corners, is_lit ? kIntersected : paint});
    if (is_lit) {
      drawing.lit.insert(drawing.lit.end(), corners.begin(), corners.end());
    }
  }
  drawing.points.insert(drawing.points.end(), points.begin(), points.end());
}

/// `all`: links besides the two.
Drawing drawing_of(const PosedArm& arm, const LitPair& pair, bool all) {
  Drawing drawing;
  add_link(arm, pair.a, kFirstMesh, &pair.triangles.a, drawing);
  add_link(arm, pair.b, kSecondMesh, &pair.triangles.b, drawing);
  for (std::size_t link = 0; all && link < arm.robot.link_count; ++link) {
    if (link != pair.a && link != pair.b) {
      add_link(arm, link, kOtherMesh, nullptr, drawing);
    }
  }
  return drawing;
}

/// Where the two lit triangles are nearest, in cells of the base's frame.
using Spot = std::array<double, 3>;
std::optional<std::pair<Spot, Spot>> nearest_places(const Drawing& drawing) {
  const Bounds bounds = bounds_of(drawing.lit);
  std::array<flashbvh::Triangle, 2> triangles{};
  for (std::size_t i = 0; i < drawing.lit.size(); ++i) {
    std::array<std::int32_t, 3> corner{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (bounds.upper[axis] - bounds.lower[axis] >= kMostSpan) {
        return std::nullopt;
      }
      corner[axis] = static_cast<std::int32_t>(drawing.lit[i][axis] - bounds.lower[axis]);
    }
    triangles[i / 3].corner[i % 3] = {corner[0], corner[1], corner[2]};
  }
  const NearestPoints nearest = nearest_points_of(triangles[0], triangles[1]);
  const auto place = [&](const FinePoint& point) {
    const std::array<std::int64_t, 3> fine = {point.x, point.y, point.z};
    Spot cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cells[axis] = static_cast<double>(bounds.lower[axis] * kFineOne + fine[axis]) / kFineOne;
    }
    return cells;
  };
  return std::pair(place(nearest.point_a), place(nearest.point_b));
}

/// Round what is lit, which may be small or hidden, and the way between the nearest points.
std::string marks(const Drawing& drawing, const View& view, const Frame& frame) {
  const Projection projection(view, frame, kDrawingSide);
  std::vector<LatticePoint> seen;
  for (const LatticePoint& corner : drawing.lit) {
    const Projected at = projection.project(corner);
    seen.push_back({at.x, at.y, 0});
  }
  const auto [low, high] = bounds_of(seen);
  const std::int64_t x = high[0] - low[0];
  const std::int64_t y = high[1] - low[1];
  std::string svg = concat("<circle cx=", (low[0] + high[0]) / 2, " cy=", (low[1] + high[1]) / 2,
                           " r=", square_root(x * x + y * y) / 2 + 30, "></circle>\n");
  if (const auto nearest = nearest_places(drawing)) {
    const auto at = [&](const Spot& place) {
      const auto& [x_cells, y_cells, z_cells] = place;
      const Projected shown =
          projection.project({std::llround(x_cells), std::llround(y_cells), std::llround(z_cells)});
      return concat(shown.x, " ", shown.y);
    };
    const std::string a = at(nearest->first);
    const std::string b = at(nearest->second);
    svg += concat("<path class=way d=\"M", a, "L", b, "\"/><path class=ends d=\"M", a, "h0M", b,
                  "h0\"/>\n");
  }
  return svg;
}

/// From the corner that shows most of what is lit.
const View& best_view(const Drawing& drawing, const Frame& frame) {
  const View* best = corner_views().data();
  std::size_t most = 0;
  for (const View& view : corner_views()) {
    const std::size_t seen = draw(drawing.scene, view, frame, kTrialSide).seen[kIntersected];
    if (seen > most) {
      best = &view;
      most = seen;
    }
  }
  return *best;
}

std::string picture(const PosedArm& arm, const Drawing& drawing, const char* caption) {
  const Frame frame = frame_of(drawing.points, corner_views());
  const View& view = best_view(drawing, frame);
  return figure(draw(drawing.scene, view, frame, kPairSide), view, frame,
                {cell_of(arm.robot), " m"}, caption, marks(drawing, view, frame), caption);
}

std::string text_of(const Spot& place, double cell) {
  return concat("(", fixed(place[0] * cell, 4), ", ", fixed(place[1] * cell, 4), ", ",
                fixed(place[2] * cell, 4), ")");
}

std::string places_note(const PosedArm& arm, const Drawing& drawing) {
  const auto nearest = nearest_places(drawing);
  if (!nearest) {
    return "";
  }
  const double cell = cell_of(arm.robot);
  const std::string a = text_of(nearest->first, cell);
  const std::string b = text_of(nearest->second, cell);
  return std::string("<p class=note>In m of the base&#39;s frame, ") +
         (a == b ? "a point of both: <code>" + a
                 : "the nearest points: <code>" + a + "</code> and <code>" + b) +
         "</code></p>\n";
}

}  // namespace

double cell_of(const Robot& robot) {
  double cell = 0;
  std::memcpy(&cell, &robot.cell_bits, sizeof cell);
  return cell;
}

std::string pair_pictures(const PosedArm& arm, const LitPair& pair) {
  const Drawing all = drawing_of(arm, pair, true);
  return "<p class=keys>" + key(class_of(kFirstMesh), escaped(arm.model.links[pair.a].name)) +
         key(class_of(kSecondMesh), escaped(arm.model.links[pair.b].name)) +
         key(class_of(kOtherMesh), "other links") + key(class_of(kIntersected), pair.what) +
         "</p>\n<div class=contacts>\n" + picture(arm, all, "The robot") +
         picture(arm, drawing_of(arm, pair, false), "The two links") + "</div>\n" +
         places_note(arm, all);
}

std::string arm_pictures(const std::vector<PosedArm>& arms,
                         const std::vector<std::string>& captions) {
  const View& view = corner_views()[0];
  std::vector<Drawing> drawings(arms.size());
  std::vector<LatticePoint> points;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    for (std::size_t link = 0; link < arms[i].robot.link_count; ++link) {
      add_link(arms[i], link, link % 2 == 0 ? kFirstMesh : kSecondMesh, nullptr, drawings[i]);
    }
    points.insert(points.end(), drawings[i].points.begin(), drawings[i].points.end());
  }
  const Frame frame = frame_of(std::move(points), {view, view, view, view});
  std::string html = "<div class=views>\n";
  for (std::size_t i = 0; i < arms.size(); ++i) {
    html += figure(draw(drawings[i].scene, view, frame, kArmSide), view, frame,
                   {cell_of(arms[i].robot), " m"}, captions[i], "", captions[i]);
  }
  return html + "</div>\n";
}

std::string links_of(const Model& model, std::size_t a, std::size_t b) {
  return escaped(model.links[a].name) + " - " + escaped(model.links[b].name);
}

std::string joint_values(const Model& model, const std::vector<double>& values) {
  std::string text;
  for (std::size_t i = 0; i < model.variables.size(); ++i) {
    text += concat(i == 0 ? "" : ", ", escaped(model.joints[model.variables[i]].name), " ",
                   significant(values[i], 6));
  }
  return text;
}

std::string arm_style() {
  return ".way{stroke:var(--text);stroke-width:2px}\n"
         ".ends{stroke:var(--text);stroke-width:7px;stroke-linecap:round}\n";
}

}  // namespace flashbvh::tool
