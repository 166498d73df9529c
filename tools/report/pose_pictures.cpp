#include <algorithm>
#include <set>

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "report/figure.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::int64_t kContactSide = 720;

/// Both meshes in A's frame, and the triangles that intersect.
struct Contact {
  Scene scene;
  Frame frame;
  std::vector<LatticePoint> lit;
};

void add_mesh(Contact& contact, const Subject& subject, const std::vector<LatticePoint>& points,
              const std::set<std::uint32_t>& lit, Paint paint) {
  for (const Triangle& triangle : subject.triangles) {
    const auto& [p, q, r] = triangle.source.vertices;
    const bool intersects = lit.count(triangle.source.number) != 0;
    contact.scene.faces.push_back(
        {{points[p], points[q], points[r]}, intersects ? kIntersected : paint});
    if (intersects) {
      contact.lit.insert(contact.lit.end(), {points[p], points[q], points[r]});
    }
  }
}

Contact contact_of(const AskedPair& pair, const Pose& pose) {
  const AnyTree& a = pair.a->image.tree();
  const AnyTree& b = pair.b->image.tree();
  std::set<std::uint32_t> of_a;
  std::set<std::uint32_t> of_b;
  const char* const algorithm = default_traversal(pair.a->image.layout());
  for (const FoundPair& found : collide(a, b, pose, algorithm, {}).pairs) {
    of_a.insert(found.a);
    of_b.insert(found.b);
  }
  Contact contact;
  std::vector<LatticePoint> points = vertices_of(a);
  const std::vector<LatticePoint> moved = transformed_vertices(b, pose);
  add_mesh(contact, *pair.a, points, of_a, kFirstMesh);
  add_mesh(contact, *pair.b, moved, of_b, kSecondMesh);
  points.insert(points.end(), moved.begin(), moved.end());
  contact.frame = frame_of(std::move(points), corner_views());
  return contact;
}

/// Round what is lit, which may be small or hidden.
std::string circle(const Contact& contact, const View& view) {
  if (contact.lit.empty()) {
    return "";
  }
  const Projection projection(view, contact.frame, kDrawingSide);
  const Bounds lit = bounds_of(contact.lit);
  const Projected low = projection.project(lit.lower);
  const Projected high = projection.project(lit.upper);
  std::int64_t radius = 0;
  for (const LatticePoint& point : contact.lit) {
    const Projected place = projection.project(point);
    const std::int64_t x = 2 * place.x - low.x - high.x;
    const std::int64_t y = 2 * place.y - low.y - high.y;
    radius = std::max(radius, square_root(x * x + y * y) / 2 + 30);
  }
  return radius > kDrawingSide / 3
             ? ""
             : concat("<circle cx=", (low.x + high.x) / 2, " cy=", (low.y + high.y) / 2,
                      " r=", radius, "></circle>\n");
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

/// From the corner that shows most of what is lit.
std::string picture(const AskedPair& pair, const PoseCost& cost, const Contact& contact,
                    const std::string& name) {
  const View* best = nullptr;
  Drawn drawn;
  for (const View& view : corner_views()) {
    Drawn next = draw(contact.scene, view, contact.frame, kContactSide);
    if (best == nullptr || next.seen[kIntersected] > drawn.seen[kIntersected]) {
      best = &view;
      drawn = std::move(next);
    }
  }
  const std::string found = cost.triangle_pairs == 0
                                ? "no triangles intersect"
                                : counted(cost.triangle_pairs, "pair of triangles intersects",
                                          "pairs of triangles intersect") +
                                      (drawn.seen[kIntersected] == 0 ? ", out of sight" : "");
  return figure(drawn, *best, contact.frame, measure_of(pair.a->image),
                name + " of " + title_of(pair) + ": " + found, circle(contact, *best),
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
  Contact costly = contact_of(pair, most->pose);
  Contact touching = contact_of(pair, first->pose);
  const bool touches = first->triangle_pairs != 0;
  if (touches) {
    costly.frame.across = touching.frame.across =
        std::max(costly.frame.across, touching.frame.across);
  }
  return "<p class=keys>" + key(class_of(kFirstMesh), escaped(pair.a->name)) +
         key(class_of(kSecondMesh), (pair.a == pair.b ? "a second " : "") + escaped(pair.b->name)) +
         key(class_of(kIntersected), "triangles that intersect") + "</p>\n<div class=contacts>\n" +
         picture(pair, *most, costly, "Costliest pose") +
         (touches ? picture(pair, *first, touching, "First contact")
                  : "<p class=note>At none of the poses do they intersect.</p>\n") +
         "</div>\n";
}

}  // namespace flashbvh::tool
