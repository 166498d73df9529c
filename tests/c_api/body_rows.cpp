// Shapes made at run time, deformable meshes, motions of a body.
#include "c_api/scene.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/shape.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {
namespace {

/// A shape has the expected status, and equal distances in both languages.
bool shape_agrees(Scene& s, flashbvh_status made, const flashbvh_mesh& c, Status status,
                  const Mesh& mesh) {
  flashbvh_clearance found;
  const auto wanted = distance(s.a.mesh, mesh, s.pose);
  return same(made, status) &&
         same(flashbvh_distance(&s.a.c, &c, &s.c_pose, nullptr, &found), wanted.status) &&
         (wanted.status != Status::done || same(found, wanted));
}

/// Sometimes too large.
bool shapes_agree(Scene& s) {
  const Point p = s.any_point();
  Point q = s.any_point();
  q.x += s.random.below(5) == 0 ? 40000 : 0;
  const Point upper = {p.x + 9, p.y, p.z + 7};
  flashbvh_segment_shape segment;
  flashbvh_box_shape box;
  const SegmentShape g(s.a.mesh, p, q);
  const BoxShape b(s.a.mesh, p, upper);
  const flashbvh_status of_segment = flashbvh_segment_shape_make(&segment, &s.a.c, &p, &q);
  const flashbvh_status of_box = flashbvh_box_shape_make(&box, &s.a.c, &p, &upper);
  return shape_agrees(s, of_segment, segment.mesh, g.status(), g.mesh()) &&
         shape_agrees(s, of_box, box.mesh, b.status(), b.mesh());
}

/// Moves a vertex of mesh A in RAM, sometimes out of the lattice, and refits in slices.
bool deformables_agree(Scene& s) {
  Node<std::uint16_t> nodes[128];
  Vertex vertices[128];
  flashbvh_node c_nodes[128];
  flashbvh_vertex c_vertices[128];
  DeformableMesh mesh(s.a.mesh, nodes, vertices);
  flashbvh_deformable c;
  flashbvh_deformable_make(&c, &s.a.c, c_nodes, c_vertices);
  const std::uint32_t moved = s.random.below(s.a.mesh.vertex_count);
  const std::int32_t most = s.random.below(3) == 0 ? 32000 : 30;
  vertices[moved].x = static_cast<std::int16_t>(s.random.between(-most, most));
  c_vertices[moved] = vertices[moved];
  RefitResult step;
  do {
    const std::uint32_t work = 1 + s.random.below(9);
    std::uint32_t vertex = 99999;
    bool yes = false;
    step = mesh.refit(work);
    const std::uint32_t wanted = step.status == Status::vertex_out_of_lattice ? step.vertex : 99999;
    const flashbvh_status refit = flashbvh_deformable_refit(&c, work, &vertex);
    const flashbvh_status itself = flashbvh_intersects_itself(&c.mesh, &yes);
    if (!same(refit, step.status) || vertex != wanted ||
        !same(itself, yes, intersects_itself(mesh.mesh()))) {
      return false;
    }
  } while (step.status == Status::suspended);
  return true;
}

/// Whether a motion is free, in slices; between them the object moves.
bool first_contacts_agree(Scene& s) {
  const bool is_far = s.random.below(9) == 0;
  const Pose to = is_far ? Pose::translated(600000, 0, 0) : any_rigid_pose(s.random, 60);
  const flashbvh_pose c_to = c_pose_of(to);
  const std::uint32_t within = s.random.below(2) == 0   ? 0
                               : s.random.below(8) == 0 ? kMaxMotionDistance + s.random.below(2)
                                                        : s.random.below(600);
  const BodyMotion motion = BodyMotion::between(s.pose, to);
  FirstContact query(s.a.mesh, s.b.mesh, motion, {within});
  flashbvh_body_motion c_motion;
  flashbvh_first_contact_query c;
  bool agree =
      same(flashbvh_body_motion_between(&s.c_pose, &c_to, &c_motion), motion.status()) &&
      same(flashbvh_first_contact_start(&c, &s.a.c, &s.b.c, &c_motion, {within}), query.status());
  for (Status status = Status::suspended; agree && status == Status::suspended;) {
    const std::uint32_t work = s.random.below(4) == 0 ? UINT32_MAX : 1 + s.random.below(900);
    const flashbvh_first_contact_query copy = c;
    wipe(c);
    c = copy;
    const FirstContactAnswer answer = query.run(work);
    const flashbvh_first_contact_answer found = flashbvh_first_contact_run(&c, work);
    status = answer.status;
    seen_outcomes |= status == Status::done ? 1u << static_cast<unsigned>(answer.outcome) : 0;
    agree = same(static_cast<flashbvh_status>(found.status), status) &&
            found.outcome == answer.outcome && same(found.triangles, answer.triangles) &&
            found.from == answer.from && found.to == answer.to;
  }
  return agree;
}

}  // namespace

std::vector<Row> body_rows() {
  return {{"shapes", shapes_agree},
          {"deformable meshes", deformables_agree},
          {"first contacts in slices", first_contacts_agree}};
}

}  // namespace flashbvh::test
