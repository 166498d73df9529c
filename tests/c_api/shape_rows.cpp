// Shapes made at run time, deformable meshes, and queries of a mesh against itself.
#include "c_api/slices.hpp"
#include "flashbvh/deformable.h"
#include "flashbvh/deformable.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/shape.h"
#include "flashbvh/shape.hpp"

namespace flashbvh::test {
namespace {

/// A shape has the expected status, and equal distances and pairs in both languages.
bool shape_agrees(Scene& s, flashbvh_status made, const flashbvh_mesh& c, Status status,
                  const Mesh& mesh) {
  flashbvh_clearance found;
  const auto wanted = distance(s.a.mesh, mesh, s.pose);
  return same(made, status) &&
         same(flashbvh_distance(&s.a.c, &c, &s.c_pose, nullptr, &found), wanted.status) &&
         (wanted.status != Status::done || same(found, wanted)) &&
         same(flashbvh_count_pairs(&c, &s.b.c, &s.c_pose), count_pairs(mesh, s.b.mesh, s.pose));
}

/// Sometimes too large.
bool shapes_agree(Scene& s) {
  Triangle t = s.any_triangle();
  t.corner[1].x += s.random.below(5) == 0 ? 40000 : 0;
  const Point upper = {t.corner[0].x + 9, t.corner[0].y, t.corner[0].z + 7};
  flashbvh_point_shape point;
  flashbvh_segment_shape segment;
  flashbvh_triangle_shape triangle;
  flashbvh_box_shape box;
  const PointShape p(s.a.mesh, t.corner[0]);
  const SegmentShape g(s.a.mesh, t.corner[0], t.corner[1]);
  const TriangleShape u(s.a.mesh, t);
  const BoxShape b(s.a.mesh, t.corner[0], upper);
  const flashbvh_status statuses[] = {
      flashbvh_point_shape_make(&point, &s.a.c, &t.corner[0]),
      flashbvh_segment_shape_make(&segment, &s.a.c, &t.corner[0], &t.corner[1]),
      flashbvh_triangle_shape_make(&triangle, &s.a.c, &t),
      flashbvh_box_shape_make(&box, &s.a.c, &t.corner[0], &upper)};
  return shape_agrees(s, statuses[0], point.mesh, p.status(), p.mesh()) &&
         shape_agrees(s, statuses[1], segment.mesh, g.status(), g.mesh()) &&
         shape_agrees(s, statuses[2], triangle.mesh, u.status(), u.mesh()) &&
         shape_agrees(s, statuses[3], box.mesh, b.status(), b.mesh());
}

constexpr std::uint32_t kMostNodes = 128;
constexpr std::uint32_t kMostVertices = 128;

/// The scene's mesh A in RAM, in both languages, with equally moved vertices.
struct Bent {
  Node<std::uint16_t> nodes[kMostNodes];
  Vertex vertices[kMostVertices];
  flashbvh_node c_nodes[kMostNodes];
  flashbvh_vertex c_vertices[kMostVertices];
  DeformableMesh mesh;
  flashbvh_deformable c;
  bool agrees;

  explicit Bent(Scene& s)
      : mesh(s.a.mesh, nodes, vertices),
        agrees(flashbvh_mesh_nodes(&s.a.c) == s.a.mesh.node_count &&
               flashbvh_mesh_vertices(&s.a.c) == s.a.mesh.vertex_count) {
    flashbvh_deformable_make(&c, &s.a.c, c_nodes, c_vertices);
    move(s, 30);
    agrees = agrees && refit(s);
  }
  void move(Scene& s, std::int32_t most) {
    const std::uint32_t vertex = s.random.below(s.a.mesh.vertex_count);
    vertices[vertex].x = static_cast<std::int16_t>(s.random.between(-most, most));
    c_vertices[vertex] = vertices[vertex];
  }
  /// Refits in slices, to the end or an error.
  bool refit(Scene& s) {
    for (bool goes_on = true; goes_on;) {
      const std::uint32_t work = 1 + s.random.below(9);
      std::uint32_t vertex = 99999;
      const RefitResult step = mesh.refit(work);
      const bool is_out = step.status == Status::vertex_out_of_lattice;
      if (!same(flashbvh_deformable_refit(&c, work, &vertex), step.status) ||
          vertex != (is_out ? step.vertex : 99999) ||
          flashbvh_deformable_refits(&c) != mesh.refits()) {
        return false;
      }
      goes_on = step.status == Status::suspended;
    }
    return true;
  }
};

Bent* bent;

struct SelfFunctions {
  using Struct = flashbvh_self_query;
  static constexpr bool kVisits = false;
  static DeformableQuery<SelfQuery> query(Scene& /*scene*/) {
    return DeformableQuery<SelfQuery>(bent->mesh);
  }
  static flashbvh_status start(Struct* c, Scene& /*scene*/) {
    return flashbvh_self_query_start(c, &bent->c);
  }
  template <class Query>
  static const QueryStats& counts_of(const Query& query) {
    return query.query().stats();
  }
  static constexpr auto run = flashbvh_self_query_run;
  static constexpr auto counts = flashbvh_self_query_stats;
  static constexpr auto position = flashbvh_self_query_cursor;
  static constexpr auto resume = flashbvh_self_query_resume;
};

struct BandFunctions : SelfFunctions {
  using Struct = flashbvh_self_within_query;
  static DeformableQuery<SelfWithinQuery> query(Scene& s) {
    return DeformableQuery<SelfWithinQuery>(bent->mesh, within({s.distance}));
  }
  static flashbvh_status start(Struct* c, Scene& s) {
    return flashbvh_self_within_start(c, &bent->c, {s.distance});
  }
  static constexpr auto run = flashbvh_self_within_run;
  static constexpr auto counts = flashbvh_self_within_stats;
  static constexpr auto position = flashbvh_self_within_cursor;
  static constexpr auto resume = flashbvh_self_within_resume;
};

/// Queries started before a refit are refused after it.
template <class C>
bool refusals_agree(Scene& s) {
  flashbvh_pair pair[1];
  typename C::Struct before;
  typename C::Struct after;
  (void)C::start(&before, s);
  const auto position = C::position(&before);
  bent->move(s, s.random.below(3) == 0 ? 32000 : 30);
  if (!bent->refit(s)) {
    return false;
  }
  auto query = C::query(s);
  return same(C::run(&before, 9, pair, 1), {Status::mesh_changed, 0, 0}) &&
         same(C::start(&after, s), query.status()) &&
         same(C::resume(&after, &position), Status::mesh_changed);
}

bool bent_agrees(Scene& s) {
  Bent here(s);
  bent = &here;
  bool yes = false;
  bool agree = here.agrees && Slices<SelfFunctions>(s).agree() && Slices<BandFunctions>(s).agree();
  const Answer itself = intersects_itself(here.mesh.mesh());
  agree = agree && same(flashbvh_intersects_itself(&here.c.mesh, &yes), itself.status) &&
          yes == itself.yes;
  return agree && refusals_agree<SelfFunctions>(s) && refusals_agree<BandFunctions>(s);
}

}  // namespace

std::vector<Row> shape_rows() {
  return {{"shapes", shapes_agree}, {"a mesh that bends, against itself", bent_agrees}};
}

}  // namespace flashbvh::test
