// Whether every query refuses a mesh.
#pragma once

#include "flashbvh/clearance.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/solid.hpp"

namespace flashbvh::test {

/// Whether each query of A and B, at rest, ends with `status` and answers yes.
template <class Index>
bool are_refused(const BasicMesh<Index, Layout::post_indexed>& a,
                 const BasicMesh<Index, Layout::post_indexed>& b,
                 Status status = Status::cell_mismatch) {
  using Mesh = BasicMesh<Index, Layout::post_indexed>;
  const Pose still = Pose::translated(0, 0, 0);
  const BodyMotion rest = BodyMotion::between(still, still);
  const auto is_refused = [status](const Answer& answer) {
    return answer.status == status && answer.yes;
  };
  const auto go_on = [](const TrianglePair<Index>&) { return true; };
  Witness<Index> none;
  Witness<Index> hint = {0, 0};
  TrianglePair<Index> found[1];
  Triangle of[2];
  DefaultQuery<Index> query(a, b, still);
  BasicClearanceQuery<Mesh> clearance(a, b, still, hint);
  Query<Ranked<Mesh>, Within> near(a, b, still, {}, within({0}));
  BasicFirstContact<Mesh> contact(a, b, rest);
  return query.status() == status && query.run(UINT32_MAX, found).status == status &&
         query.resume(query.cursor()) == status && near.status() == status &&
         near.run(UINT32_MAX, found).status == status && is_refused(intersects(a, b, still)) &&
         is_refused(intersects(a, b, still, none)) && is_refused(intersects(a, b, still, hint)) &&
         is_refused(first_pair(a, b, still, found[0])) &&
         count_pairs(a, b, still).status == status &&
         find_pairs(a, b, still, found, 1).status == status &&
         for_each_pair(a, b, still, go_on) == status && is_refused(closer_than(a, b, still, {0})) &&
         distance(a, b, still).status == status && distance(a, b, still, hint).status == status &&
         clearance.run(UINT32_MAX).status == status && clearance.result().lower == 0 &&
         clearance.resume(clearance.cursor()) == status &&
         is_refused(solids_intersect(a, b, still)) && is_refused(one_is_inside(a, b, still)) &&
         contact_at(a, b, still).status == status && contact_at(a, b, still).yes &&
         contact.status() == status && contact.run(UINT32_MAX).status == status &&
         contact.run(UINT32_MAX).outcome != ContactOutcome::free &&
         contact.resume(contact.cursor()) == status &&
         !transform_pair(a, b, still, {0, 0}, of[0], of[1]);
}

/// For classes that derive from Mesh.
inline bool are_refused(const Mesh& a, const Mesh& b, Status status = Status::cell_mismatch) {
  return are_refused<uint16_t>(a, b, status);
}

/// Whether each ray and each query of the mesh with itself ends with `status` and answers yes, and
/// each question for its inside with `open_status`.
template <class Index>
bool is_refused(const BasicMesh<Index, Layout::post_indexed>& mesh, Status status,
                Status open_status) {
  using Mesh = BasicMesh<Index, Layout::post_indexed>;
  const Segment ray = {{0, 0, 100}, {0, 0, -100}};
  const auto go_on = [](const RayHit<Index>&) { return true; };
  TrianglePair<Index> found[1];
  BasicSelfQuery<Mesh, detail::Intersection> query(mesh);
  BasicSelfQuery<Mesh, Within> near(mesh, within({0}));
  const auto hinted = nearest_hit(mesh, ray, Index{0});
  const auto nearest = nearest_hit(mesh, ray);
  const auto any = any_hit(mesh, ray);
  const auto itself = intersects_itself(mesh);
  const auto of_point = inside(mesh, {0, 0, 0});
  return hinted.status == status && hinted.yes && nearest.status == status && nearest.yes &&
         any.status == status && any.yes && for_each_hit(mesh, ray, go_on) == status &&
         signed_crossings(mesh, ray).status == open_status && of_point.status == open_status &&
         of_point.side == PointSide::inside && itself.status == status && itself.yes &&
         query.run(UINT32_MAX, found).status == status &&
         near.run(UINT32_MAX, found).status == status;
}

/// An object that no constructor made, as at namespace scope without a start-up's help.
template <class Object>
class Zeros {
 public:
  Object& operator*() { return *reinterpret_cast<Object*>(bytes_); }
  Object* operator->() { return reinterpret_cast<Object*>(bytes_); }

 private:
  alignas(Object) unsigned char bytes_[sizeof(Object)] = {};
};

}  // namespace flashbvh::test
