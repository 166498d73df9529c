// Distances, rays, solids.
#include "c_api/scene.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"

namespace flashbvh::test {
namespace {

flashbvh_witness any_hint(Scene& s) {
  const auto a = static_cast<std::uint16_t>(s.random.below(5));
  const auto b = static_cast<std::uint16_t>(s.random.below(5));
  return {a, b};
}

bool distance_agrees(Scene& s) {
  const flashbvh_witness hint = any_hint(s);
  flashbvh_clearance found;
  const auto wanted = distance(s.a.mesh, s.b.mesh, s.pose);
  const auto hinted = distance(s.a.mesh, s.b.mesh, s.pose, {hint.a, hint.b});
  bool agree = same(flashbvh_distance(&s.a.c, &s.b.c, &s.c_pose, nullptr, &found), wanted.status) &&
               same(found, wanted);
  agree = agree && same(flashbvh_distance(&s.a.c, &s.b.c, &s.c_pose, &hint, &found), hinted.status);
  return agree && (hinted.status != Status::done || same(found, hinted));
}

/// In slices; between them the object moves.
bool clearance_agrees(Scene& s) {
  const flashbvh_witness hint = any_hint(s);
  const bool is_hinted = s.random.below(2) == 0;
  ClearanceQuery::Options options;
  options.hint = is_hinted ? ClearanceQuery::Hint{hint.a, hint.b} : ClearanceQuery::Hint();
  ClearanceQuery query(s.a.mesh, s.b.mesh, s.pose, options);
  flashbvh_clearance_query c;
  bool agree =
      same(flashbvh_clearance_start(&c, &s.a.c, &s.b.c, &s.c_pose, is_hinted ? &hint : nullptr),
           query.status());
  for (Status status = Status::suspended; agree && status == Status::suspended;) {
    const std::uint32_t work = 1 + s.random.below(9);
    std::uint32_t c_left = work;
    const flashbvh_clearance_query copy = c;
    wipe(c);
    c = copy;
    const RunResult step = query.run(work);
    status = step.status;
    flashbvh_clearance found;
    agree = same(flashbvh_clearance_run(&c, &c_left), status) && work - c_left == step.work;
    flashbvh_clearance_result(&c, &found);
    agree = agree && same(found, query.result());
  }
  return agree;
}

bool closer_agrees(Scene& s) {
  bool yes = false;
  const flashbvh_status c = flashbvh_closer_than(&s.a.c, &s.b.c, &s.c_pose, {s.distance}, &yes);
  return same(c, yes, closer_than(s.a.mesh, s.b.mesh, s.pose, {s.distance}));
}

bool hit_agrees(Scene& s, const Segment& ray, std::uint16_t hint) {
  flashbvh_hit hit;
  bool yes = false;
  const auto nearest = nearest_hit(s.a.mesh, ray, hint);
  const flashbvh_status c = flashbvh_nearest_hit(&s.a.c, &ray, hint, &yes, &hit);
  if (!same(c, nearest.status) || yes != nearest.yes) {
    return false;
  }
  return nearest.status != Status::done || !yes ||
         (hit.above == nearest.hit.along.above && hit.below == nearest.hit.along.below &&
          hit.triangle == nearest.hit.triangle && hit.slot == nearest.hit.slot &&
          hit.side == nearest.hit.side &&
          flashbvh_distance_along(&ray, &hit) == distance_along(ray, nearest.hit.along));
}

bool rays_agree(Scene& s) {
  const Point from = s.any_point();
  Segment ray = {from, s.any_point()};
  ray.to.x += s.random.below(9) == 0 ? 600000 : 0;
  const auto hint = static_cast<std::uint16_t>(s.random.below(30));
  return hit_agrees(s, ray, FLASHBVH_NO_HINT) && hit_agrees(s, ray, hint);
}

bool float_rays_agree(Scene& s) {
  float number[7];
  for (float& any : number) {
    any = static_cast<float>(s.random.between(-999, 999)) / 7;
  }
  const float origin[3] = {number[0], number[1], s.random.below(5) == 0 ? 1e30f : number[2]};
  const float direction[3] = {number[3], number[4], number[5]};
  flashbvh_segment made = {};
  const MadeSegment wanted = segment_of(origin, direction, number[6], 10);
  return same(flashbvh_segment_of(origin, direction, number[6], 10, &made), wanted.status) &&
         same(made, wanted.status == Status::done ? wanted.segment : Segment{});
}

bool solids_agree(Scene& s) {
  const Point point = s.any_point();
  const PointAnswer at = inside(s.a.mesh, point);
  flashbvh_point_side side;
  bool yes = false;
  const flashbvh_status c = flashbvh_one_is_inside(&s.a.c, &s.b.c, &s.c_pose, &yes);
  return same(c, yes, one_is_inside(s.a.mesh, s.b.mesh, s.pose)) &&
         same(flashbvh_inside(&s.a.c, &point, &side), at.status) &&
         side == static_cast<flashbvh_point_side>(at.side);
}

}  // namespace

std::vector<Row> distance_rows() {
  return {{"the distance", distance_agrees},     {"the distance in slices", clearance_agrees},
          {"whether it is less", closer_agrees}, {"rays", rays_agree},
          {"rays of floats", float_rays_agree},  {"solids", solids_agree}};
}

}  // namespace flashbvh::test
