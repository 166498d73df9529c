#include <algorithm>
#include <set>

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "report/html.hpp"
#include "report/picture.hpp"
#include "report/sections.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

void add_mesh(Faces& faces, const Subject& subject, const std::vector<LatticePoint>& points,
              const std::set<std::uint32_t>& lit, Paint paint) {
  for (const Triangle& triangle : subject.triangles) {
    const auto& [p, q, r] = triangle.source.vertices;
    const bool intersects = lit.count(triangle.source.number) != 0;
    faces.push_back(
        {{points[p], points[q], points[r]}, intersects ? kIntersected : paint, triangle.is_solid});
  }
}

/// Both meshes in A's frame, and the triangles that intersect marked.
Faces contact_of(const AskedPair& pair, const Pose& pose) {
  const AnyTree& a = pair.a->image.tree();
  const AnyTree& b = pair.b->image.tree();
  std::set<std::uint32_t> of_a;
  std::set<std::uint32_t> of_b;
  const char* const algorithm = default_traversal(pair.a->image.layout());
  for (const FoundPair& found : collide(a, b, pose, algorithm, {}).pairs) {
    of_a.insert(found.a);
    of_b.insert(found.b);
  }
  Faces faces;
  add_mesh(faces, *pair.a, vertices_of(a), of_a, kFirstMesh);
  add_mesh(faces, *pair.b, transformed_vertices(b, pose), of_b, kSecondMesh);
  return faces;
}

/// As `collide --poses` reads it.
std::string line_of(const Pose& pose, double cell) {
  std::string line;
  for (int i = 0; i < 9; ++i) {
    line += shortest(static_cast<double>(pose.rotation(i / 3, i % 3)) / kRotationOne) + " ";
  }
  for (int i = 0; i < 3; ++i) {
    line += shortest((pose.translation(i) + pose.fraction(i) / 65536.0) * cell) + " ";
  }
  return line;
}

std::string picture(const AskedPair& pair, const PoseCost& cost, const Faces& faces,
                    const std::string& name) {
  const Frame frame(views()[0], points_of(faces));
  const std::string found = cost.triangle_pairs == 0
                                ? "no triangles intersect"
                                : counted(cost.triangle_pairs, "pair of triangles intersects",
                                          "pairs of triangles intersect");
  return figure(faces, frame, measure_of(pair.a->image),
                name + " of " + title_of(pair) + ": " + found, circle(faces, frame),
                concat("<b>", name, ":</b> ", grouped(cost.work), " work; ", found,
                       ".<details><summary>The pose</summary><code>",
                       line_of(cost.pose, pair.a->image.cell()), "</code></details>"));
}

}  // namespace

std::string pose_pictures(const AskedPair& pair) {
  const std::vector<PoseCost>& poses = pair.costs.poses;
  const auto most =
      std::max_element(poses.begin(), poses.end(),
                       [](const PoseCost& p, const PoseCost& q) { return p.work < q.work; });
  // Those that do not intersect wrap to the end.
  const auto first =
      std::min_element(poses.begin(), poses.end(), [](const PoseCost& p, const PoseCost& q) {
        return p.triangle_pairs - 1 < q.triangle_pairs - 1;
      });
  return "<p class=keys>" + key(class_of(kFirstMesh), escaped(pair.a->name)) +
         key(class_of(kSecondMesh), (pair.a == pair.b ? "a second " : "") + escaped(pair.b->name)) +
         key(class_of(kIntersected), "triangles that intersect") + "</p>\n<div class=contacts>\n" +
         picture(pair, *most, contact_of(pair, most->pose), "Costliest pose") +
         (first->triangle_pairs != 0
              ? picture(pair, *first, contact_of(pair, first->pose), "First contact")
              : note("At none of the poses do they intersect.")) +
         "</div>\n";
}

}  // namespace flashbvh::tool
