#include "report/arm_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "evaluate/poses.hpp"
#include "flashbvh/clearance.hpp"
#include "report/html.hpp"
#include "report/picture.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Differences of corners that nearest_points_of() takes are below it.
constexpr std::int64_t kMostSpan = 1 << 17;

template <class MeshType>
bool is_link_solid(const MeshType& mesh) {
  bake::LatticeMesh lattice;
  lattice.vertices.assign(mesh.vertices, mesh.vertices + mesh.vertex_count);
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& [p, q, r] = mesh.triangles[i].corner;
    lattice.triangles.push_back({p, q, r});
  }
  return is_solid(lattice);
}

/// `lit`: the id of a triangle, or null.
template <class MeshType>
void add_mesh(const MeshType& mesh, const Pose& pose, Paint paint, const std::uint32_t* lit,
              Faces& faces) {
  using Tree = BasicMeshWithLevels<typename MeshType::Index, Layout::post_indexed>;
  const std::vector<LatticePoint> points =
      transformed_vertices(AnyTree(Tree{mesh, nullptr, nullptr}), pose);
  const bool solid = is_link_solid(mesh);
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& corner = mesh.triangles[i].corner;
    const bool is_lit = lit != nullptr && mesh.triangle_ids[i] == *lit;
    faces.push_back({{points[corner[0]], points[corner[1]], points[corner[2]]},
                     is_lit ? kIntersected : paint,
                     solid});
  }
}

void add_link(const PosedArm& arm, std::size_t link, Paint paint, const std::uint32_t* lit,
              Faces& faces) {
  std::visit([&](const auto& mesh) { add_mesh(mesh, arm.poses[link], paint, lit, faces); },
             arm.meshes[link]);
}

/// The two links, a's mark first; `all`: the other links, too.
Faces faces_of(const PosedArm& arm, const LitPair& pair, bool all) {
  Faces faces;
  add_link(arm, pair.a, kFirstMesh, &pair.triangles.a, faces);
  add_link(arm, pair.b, kSecondMesh, &pair.triangles.b, faces);
  for (std::size_t link = 0; all && link < arm.model.link_count(); ++link) {
    if (link != pair.a && link != pair.b) {
      add_link(arm, link, kOtherMesh, nullptr, faces);
    }
  }
  return faces;
}

/// Where the two lit triangles are nearest, in cells of the base's frame.
using Spot = std::array<double, 3>;
std::optional<std::pair<Spot, Spot>> nearest_places(const Faces& faces) {
  const std::vector<LatticePoint> lit = marked_corners(faces);
  LatticePoint origin = lit[0];
  for (const LatticePoint& corner : lit) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = std::min(origin[axis], corner[axis]);
    }
  }
  std::array<flashbvh::Triangle, 2> triangles{};
  for (std::size_t i = 0; i < lit.size(); ++i) {
    std::array<std::int32_t, 3> corner{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (lit[i][axis] - origin[axis] >= kMostSpan) {
        return std::nullopt;
      }
      corner[axis] = static_cast<std::int32_t>(lit[i][axis] - origin[axis]);
    }
    triangles[i / 3].corner[i % 3] = {corner[0], corner[1], corner[2]};
  }
  const NearestPoints nearest = nearest_points_of(triangles[0], triangles[1]);
  const auto place = [&](const FinePoint& point) {
    const std::array<std::int64_t, 3> fine = {point.x, point.y, point.z};
    Spot cells{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cells[axis] = static_cast<double>(origin[axis] * kFineOne + fine[axis]) / kFineOne;
    }
    return cells;
  };
  return std::pair(place(nearest.point_a), place(nearest.point_b));
}

/// A circle round the two triangles, and the line between the nearest points.
std::string marks(const Faces& faces, const Frame& frame) {
  const auto nearest = nearest_places(faces);
  if (!nearest) {
    return circle(faces, frame);
  }
  const auto at = [&](const Spot& place) {
    const Vector shown =
        frame.project({std::llround(place[0]), std::llround(place[1]), std::llround(place[2])});
    return concat(shown[0], " ", shown[1]);
  };
  const std::string a = at(nearest->first);
  const std::string b = at(nearest->second);
  return circle(faces, frame) + "<path class=way d=\"M" + a + "L" + b +
         "\"/><path class=ends d=\"M" + a + "h0M" + b + "h0\"/>\n";
}

std::string picture(const PosedArm& arm, const Faces& faces, const char* caption) {
  const Frame frame(points_of(faces));
  return figure(faces, frame, {arm.cell, " m"}, caption, marks(faces, frame), caption);
}

std::string text_of(const Spot& place, double cell) {
  return concat("(", fixed(place[0] * cell, 4), ", ", fixed(place[1] * cell, 4), ", ",
                fixed(place[2] * cell, 4), ")");
}

std::string places_note(const PosedArm& arm, const Faces& faces) {
  const auto nearest = nearest_places(faces);
  if (!nearest) {
    return "";
  }
  const double cell = arm.cell;
  const std::string a = text_of(nearest->first, cell);
  const std::string b = text_of(nearest->second, cell);
  return note("In m of the base&#39;s frame, " +
              (a == b ? "a point of both: <code>" + a
                      : "the nearest points: <code>" + a + "</code> and <code>" + b) +
              "</code>");
}

}  // namespace

std::string pair_pictures(const PosedArm& arm, const LitPair& pair) {
  const Faces all = faces_of(arm, pair, true);
  return "<p class=keys>" + key(class_of(kFirstMesh), escaped(arm.model.links[pair.a].name)) +
         key(class_of(kSecondMesh), escaped(arm.model.links[pair.b].name)) +
         key(class_of(kOtherMesh), "other links") + key(class_of(kIntersected), pair.what) +
         "</p>\n<div class=contacts>\n" + picture(arm, all, "The robot") +
         picture(arm, faces_of(arm, pair, false), "The two links") + "</div>\n" +
         places_note(arm, all);
}

std::string arm_pictures(const std::vector<PosedArm>& arms,
                         const std::vector<std::string>& captions) {
  std::vector<Faces> drawings(arms.size());
  Faces all;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    for (std::size_t link = 0; link < arms[i].model.link_count(); ++link) {
      add_link(arms[i], link, link % 2 == 0 ? kFirstMesh : kSecondMesh, nullptr, drawings[i]);
    }
    all.insert(all.end(), drawings[i].begin(), drawings[i].end());
  }
  const Frame frame(points_of(all));
  std::string html = "<div class=views>\n";
  for (std::size_t i = 0; i < arms.size(); ++i) {
    std::string outlines;
    for (const Ball& ball : arms[i].balls) {
      outlines += outline(ball.centre, ball.radius, frame);
    }
    html += figure(drawings[i], frame, {arms[i].cell, " m"}, captions[i], outlines, captions[i]);
  }
  return html + "</div>\n";
}

std::string links_of(const Model& model, std::size_t a, std::size_t b) {
  return escaped(model.links[a].name) + " - " + escaped(model.links[b].name);
}

std::string joint_values(const Model& model, const std::vector<double>& values) {
  return joined(model.variables, [&](std::size_t joint) {
    const ModelJoint& of = model.joints[joint];
    return escaped(of.name) + " " + significant(values[of.variable], 6);
  });
}

std::string decision(const std::string& style, const std::string& what, const std::string& of) {
  return "<li>" + square(style) + "<b>" + what + "</b>" + (of.empty() ? "" : ": " + of) + "</li>\n";
}

std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  std::map<WhyUnguarded, std::vector<UnguardedPair>> by_reason;
  for (const UnguardedPair& pair : unguarded) {
    by_reason[pair.why].push_back(pair);
  }
  std::string html;
  for (const auto& [why, pairs] : by_reason) {
    html += decision(
        "v1", "Not guarded",
        escaped(names_of(model, pairs) + (why == WhyUnguarded::believed
                                              ? " (" + reason_of(model, pairs.front()) + ")"
                                              : "")));
  }
  return html;
}

std::string decision_section(const std::string& title, const std::string& decisions) {
  return section("decision", title, "<ul class=verdict>\n" + decisions + "</ul>");
}

std::string footer() {
  return "<footer>" + note(version_text()) + "</footer>\n";
}

}  // namespace flashbvh::tool
