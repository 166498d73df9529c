// Winding numbers, counted along +z.
#include "flashbvh/solid.hpp"

#include "../lattice/mesh_frame.hpp"
#include "../predicates/segment_hit.hpp"
#include "flashbvh/detail/bounds/gap.hpp"
#include "flashbvh/detail/bounds/transform.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/walk/subtree.hpp"

namespace flashbvh {
namespace detail {
namespace {

/// Returns 1 or -1, by the triangle's orientation, if the triangle is above the point; else 0. The
/// point is not on the triangle.
int crossing(const Triangle& t, const Point& p) {
  const int side = passage(t, p, {0, 0, 1});
  return side_of_plane(t, p) == -side ? side : 0;
}

/// Leaves a mesh in its own lattice.
template <class Mesh>
class Unmoved {
 public:
  explicit Unmoved(const Mesh& mesh) : mesh_(mesh) {}
  SeenBox seen(const PackedBox& box) const { return seen_translated(box, kNoOffset); }
  void get(uint32_t position, Triangle& t) const {
    translate_triangle(mesh_, position, kNoOffset, t);
  }

 private:
  const Mesh& mesh_;
};

/// Places B in A's lattice by its pose.
template <class Mesh>
class Moved {
 public:
  Moved(const Mesh& b, const Transform& transform)
      : b_(b), transform_(transform), rotated_(transform.rotated(), GapLimit(0)) {}
  SeenBox seen(const PackedBox& box) {
    return transform_.is_rotated() ? rotated_.seen_of_b(box)
                                   : seen_translated(box, transform_.translated().offset);
  }
  void get(uint32_t position, Triangle& t) const {
    transform_triangle(b_, position, transform_, t);
  }

 private:
  const Mesh& b_;
  const Transform& transform_;
  RotatedGap rotated_;
};

/// Returns whether a box contains the point or has a point straight above it.
bool may_be_above(const SeenBox& box, const Point& p) {
  return p.x <= box.upper[0] - kBoundBias && -p.x <= box.lower[0] - kBoundBias &&
         p.y <= box.upper[1] - kBoundBias && -p.y <= box.lower[1] - kBoundBias &&
         p.z <= box.upper[2] - kBoundBias;
}

/// `p`: coordinates within +-2^17; the mesh is closed.
template <class Mesh, class Place>
PointSide find_side(const Mesh& mesh, Place place, const Point& p, uint32_t& visits) {
  int winding = 0;
  Subtree<typename Mesh::Index, Mesh::kLayout> at(mesh, 0, 0);
  do {
    ++visits;
    while (may_be_above(place.seen(at.node().box), p)) {
      if (!at.node().is_leaf()) {
        at.descend();
        ++visits;
        continue;
      }
      const uint32_t leaf = at.node().leaf();
      for (uint32_t i = mesh.first_triangle(leaf); i < mesh.end_triangle(leaf); ++i) {
        Triangle t;
        place.get(i, t);
        if (triangles_intersect(t, {{p, p, p}})) {
          return PointSide::on_surface;
        }
        winding += crossing(t, p);
      }
      break;
    }
  } while (at.next());
  return winding != 0 ? PointSide::inside : PointSide::outside;
}

/// Returns whether the first vertex of any shell, placed by `to_point`, is not outside `other`.
template <class Mesh, class ToPoint, class Other, class Place>
bool has_shell_inside(const Mesh& mesh, const ToPoint& to_point, const Other& other,
                      const Place& place) {
  uint32_t visits = 0;
  for (uint32_t i = 0; i < mesh.shell_count; ++i) {
    const Point p = to_point(mesh.vertices[mesh.shell_vertices[i]]);
    if (find_side(other, place, p, visits) != PointSide::outside) {
      return true;
    }
  }
  return false;
}

}  // namespace
}  // namespace detail

template <class Index>
PointAnswer inside(const BasicMesh<Index, Layout::post_indexed>& mesh,
                   const Point& point) noexcept {
  if (!mesh.is_closed || !detail::is_usable(mesh)) {
    return {detail::has_cell(mesh) ? Status::not_closed : Status::not_open, PointSide::inside, 0};
  }
  PointAnswer answer = {Status::done, PointSide::outside, 0};
  Point p;
  if (!detail::get_from_origin(mesh.origin, point, kMaxCoordinate, p)) {
    return answer;
  }
  using MeshType = BasicMesh<Index, Layout::post_indexed>;
  answer.side = detail::find_side(mesh, detail::Unmoved<MeshType>(mesh), p, answer.visits);
  return answer;
}

namespace {

template <class MeshType>
Status solids_error(const MeshType& a, const MeshType& b, const Pose& pose) {
  if (!detail::have_one_cell(a, b)) {
    return detail::cell_error(a, b);
  }
  if (pose.status() != Status::done) {
    return pose.status();
  }
  return a.is_closed && b.is_closed ? Status::done : Status::not_closed;
}

// The two tests of solids_intersect are not inlined, so that their stack frames do not add up.

template <class MeshType>
[[gnu::noinline]] bool has_one_inside(const MeshType& a, const MeshType& b, const Pose& pose) {
  detail::Transform transform(pose, a, b, /*may_stop=*/false);
  transform.bring_near();
  const auto of_b = [&transform](const Vertex& v) -> Point {
    if (transform.is_rotated()) {
      return transform.rotated().transform(v);
    }
    const Point& t = transform.translated().offset;
    return {v.x + t.x, v.y + t.y, v.z + t.z};
  };
  const auto of_a = [](const Vertex& v) -> Point { return {v.x, v.y, v.z}; };
  return detail::has_shell_inside(b, of_b, a, detail::Unmoved<MeshType>(a)) ||
         detail::has_shell_inside(a, of_a, b, detail::Moved<MeshType>(b, transform));
}

template <class MeshType>
[[gnu::noinline]] Answer surfaces_intersect(const MeshType& a, const MeshType& b,
                                            const Pose& pose) {
  return intersects(a, b, pose);
}

}  // namespace

template <class Index>
Answer one_is_inside(const BasicMesh<Index, Layout::post_indexed>& a,
                     const BasicMesh<Index, Layout::post_indexed>& b, const Pose& pose) noexcept {
  const Status error = solids_error(a, b, pose);
  if (error != Status::done) {
    return {error, true};
  }
  return {Status::done, has_one_inside(a, b, pose)};
}

template <class Index>
Answer solids_intersect(const BasicMesh<Index, Layout::post_indexed>& a,
                        const BasicMesh<Index, Layout::post_indexed>& b,
                        const Pose& pose) noexcept {
  const Answer surfaces = surfaces_intersect(a, b, pose);
  return surfaces.yes ? surfaces : one_is_inside(a, b, pose);
}

template PointAnswer inside(const Mesh&, const Point&) noexcept;
template PointAnswer inside(const Mesh32&, const Point&) noexcept;
template Answer one_is_inside(const Mesh&, const Mesh&, const Pose&) noexcept;
template Answer one_is_inside(const Mesh32&, const Mesh32&, const Pose&) noexcept;
template Answer solids_intersect(const Mesh&, const Mesh&, const Pose&) noexcept;
template Answer solids_intersect(const Mesh32&, const Mesh32&, const Pose&) noexcept;

}  // namespace flashbvh
