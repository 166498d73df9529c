// Distances, proximity, rays and solids.
#include "c_api/slices.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.h"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.h"
#include "flashbvh/solid.hpp"

namespace flashbvh::test {
namespace {

struct WithinFunctions {
  using Struct = flashbvh_within_query;
  static constexpr bool kVisits = true;
  static WithinQuery query(Scene& s) {
    return WithinQuery(s.a.mesh, s.b.mesh, s.pose, {}, within({s.distance}));
  }
  static flashbvh_status start(Struct* c, Scene& s) {
    return flashbvh_within_start(c, &s.a.c, &s.b.c, &s.c_pose, {s.distance});
  }
  static const QueryStats& counts_of(const WithinQuery& query) { return query.stats(); }
  static constexpr auto status = flashbvh_within_status;
  static constexpr auto run = flashbvh_within_run;
  static constexpr auto visit = flashbvh_within_visit;
  static constexpr auto counts = flashbvh_within_stats;
  static constexpr auto position = flashbvh_within_cursor;
  static constexpr auto resume = flashbvh_within_resume;
  static constexpr auto last_pair = flashbvh_within_last_pair;
};

bool distance_agrees(Scene& s) {
  const flashbvh_witness pair = {static_cast<std::uint16_t>(s.random.below(5)),
                                 static_cast<std::uint16_t>(s.random.below(5))};
  flashbvh_clearance found;
  const auto wanted = distance(s.a.mesh, s.b.mesh, s.pose);
  const auto seeded = distance(s.a.mesh, s.b.mesh, s.pose, {pair.a, pair.b});
  bool agree = same(flashbvh_distance(&s.a.c, &s.b.c, &s.c_pose, nullptr, &found), wanted.status) &&
               same(found, wanted);
  agree = agree && same(flashbvh_distance(&s.a.c, &s.b.c, &s.c_pose, &pair, &found), seeded.status);
  return agree && (seeded.status != Status::done || same(found, seeded));
}

/// Runs in slices, each in a new object.
bool clearance_agrees(Scene& s) {
  const auto tolerance = static_cast<std::uint16_t>(s.random.below(2000));
  const flashbvh_clearance_options options = {nullptr, tolerance};
  ClearanceQuery query(s.a.mesh, s.b.mesh, s.pose, ClearanceQuery::Options{{}, tolerance});
  flashbvh_clearance_query c;
  bool agree =
      same(flashbvh_clearance_start(&c, &s.a.c, &s.b.c, &s.c_pose, &options), query.status());
  for (Status status = Status::suspended; agree && status == Status::suspended;) {
    const std::uint32_t work = 1 + s.random.below(9);
    std::uint32_t c_left = work;
    const flashbvh_cursor position = flashbvh_clearance_cursor(&c);
    const auto wanted = query.cursor();
    wipe(c);
    (void)flashbvh_clearance_start(&c, &s.a.c, &s.b.c, &s.c_pose, &options);
    ClearanceQuery again(s.a.mesh, s.b.mesh, s.pose, ClearanceQuery::Options{{}, tolerance});
    agree = same(position, wanted) &&
            same(flashbvh_clearance_resume(&c, &position), again.resume(wanted));
    query = again;
    const RunResult step = query.run(work);
    status = step.status;
    flashbvh_clearance found;
    agree = agree && same(flashbvh_clearance_run(&c, &c_left), status) &&
            work - c_left == step.work && same(flashbvh_clearance_stats(&c), query.stats());
    flashbvh_clearance_result(&c, &found);
    agree = agree && same(found, query.result());
  }
  return agree;
}

bool closer_agrees(Scene& s) {
  bool yes = false;
  const Answer answer = closer_than(s.a.mesh, s.b.mesh, s.pose, {s.distance});
  return same(flashbvh_closer_than(&s.a.c, &s.b.c, &s.c_pose, {s.distance}, &yes), answer.status) &&
         yes == answer.yes;
}

bool nearest_agrees(Scene& s) {
  WithinQuery query(s.a.mesh, s.b.mesh, s.pose, {}, within({s.distance}));
  flashbvh_within_query c;
  flashbvh_pair pair[1];
  std::uint32_t wanted = 0;
  Kept visited = {9, 0, {}};
  (void)flashbvh_within_start(&c, &s.a.c, &s.b.c, &s.c_pose, {s.distance});
  bool agree = true;
  Status status = Status::full;
  while (agree && wanted < visited.most &&
         (status = query.run(UINT32_MAX, pair).status) == Status::full) {
    Triangle a;
    Triangle b;
    NearestPoints last;
    NearestPoints again;
    ++wanted;
    query.last_pair(a, b);
    agree = flashbvh_within_run(&c, UINT32_MAX, pair, 1).status == Status::full;
    flashbvh_within_last_nearest_points(&c, &last);
    flashbvh_nearest_points_of(&a, &b, &again);
    agree = agree && same(last, nearest_points_of(a, b)) && same(again, last);
  }
  return agree &&
         same(flashbvh_for_each_within(&s.a.c, &s.b.c, &s.c_pose, {s.distance}, keep, &visited),
              status) &&
         visited.count == wanted;
}

bool same_hit(const flashbvh_hit& c, const RayHit<std::uint16_t>& hit) {
  return c.above == hit.along.above && c.below == hit.along.below && c.triangle == hit.triangle &&
         c.slot == hit.slot && c.side == hit.side;
}

bool hits_agree(Scene& s, const Segment& ray) {
  const auto seed = static_cast<std::uint16_t>(s.random.below(30));
  flashbvh_hit hit;
  bool yes = false;
  const auto any = any_hit(s.a.mesh, ray);
  const auto seeded = nearest_hit(s.a.mesh, ray, seed);
  const auto nearest = nearest_hit(s.a.mesh, ray);
  bool agree = same(flashbvh_any_hit(&s.a.c, &ray, &yes, &hit), any.status) && yes == any.yes &&
               (any.status != Status::done || !yes || same_hit(hit, any.hit));
  agree = agree && same(flashbvh_nearest_hit(&s.a.c, &ray, seed, &yes, &hit), seeded.status);
  agree = agree &&
          same(flashbvh_nearest_hit(&s.a.c, &ray, FLASHBVH_NO_HINT, &yes, &hit), nearest.status) &&
          yes == nearest.yes;
  if (agree && nearest.status == Status::done && nearest.yes) {
    flashbvh_fine_point at;
    flashbvh_point_along(&ray, &hit, &at);
    agree = same_hit(hit, nearest.hit) && same(at, point_along(ray, nearest.hit.along)) &&
            flashbvh_distance_along(&ray, &hit) == distance_along(ray, nearest.hit.along);
  }
  return agree;
}

/// The sum of a visitor's arguments.
bool add_hit(const flashbvh_hit* hit, void* context) {
  return (*static_cast<std::uint32_t*>(context) += hit->triangle + 1u) < 40;
}

bool rays_agree(Scene& s) {
  Segment ray = {s.any_point(), s.any_point()};
  ray.to.x += s.random.below(9) == 0 ? 600000 : 0;
  std::uint32_t sum = 0;
  std::uint32_t wanted = 0;
  std::int32_t outwards = 99;
  const Status status = for_each_hit(s.a.mesh, ray, [&](const RayHit<std::uint16_t>& hit) {
    return (wanted += hit.triangle + 1u) < 40;
  });
  const CrossingCount count = signed_crossings(s.a.mesh, ray);
  return hits_agree(s, ray) && same(flashbvh_for_each_hit(&s.a.c, &ray, add_hit, &sum), status) &&
         sum == wanted && same(flashbvh_signed_crossings(&s.a.c, &ray, &outwards), count.status) &&
         outwards == count.outwards;
}

bool float_rays_agree(Scene& s) {
  const auto number = [&] { return static_cast<float>(s.random.between(-999, 999)) / 7; };
  const float origin[3] = {number(), number(), s.random.below(5) == 0 ? 1e30f : number()};
  const float direction[3] = {number(), number(), number()};
  const float reach = number();
  flashbvh_segment made = {};
  const MadeSegment wanted = segment_of(origin, direction, reach, 10);
  return same(flashbvh_segment_of(origin, direction, reach, 10, &made), wanted.status) &&
         same(made, wanted.status == Status::done ? wanted.segment : Segment{});
}

bool solids_agree(Scene& s) {
  const Point point = s.any_point();
  const PointAnswer at = inside(s.a.mesh, point);
  const Answer one = one_is_inside(s.a.mesh, s.b.mesh, s.pose);
  const Answer both = solids_intersect(s.a.mesh, s.b.mesh, s.pose);
  flashbvh_point_side side;
  bool is_one = false;
  bool is_both = false;
  return same(flashbvh_inside(&s.a.c, &point, &side), at.status) &&
         side == static_cast<flashbvh_point_side>(at.side) &&
         same(flashbvh_one_is_inside(&s.a.c, &s.b.c, &s.c_pose, &is_one), one.status) &&
         same(flashbvh_solids_intersect(&s.a.c, &s.b.c, &s.c_pose, &is_both), both.status) &&
         is_one == one.yes && is_both == both.yes;
}

}  // namespace

std::vector<Row> distance_rows() {
  return {{"the distance", distance_agrees},
          {"the distance in slices", clearance_agrees},
          {"whether it is less", closer_agrees},
          {"a band in slices", [](Scene& s) { return Slices<WithinFunctions>(s).agree(); }},
          {"where pairs are nearest", nearest_agrees},
          {"rays", rays_agree},
          {"rays of floats", float_rays_agree},
          {"solids", solids_agree}};
}

}  // namespace flashbvh::test
