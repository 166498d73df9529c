// The entries: one for each public query, which asks that query and nothing else.
//
// Each is compiled alone, so that it has what it would have in a firmware; the build makes a source
// of each, and the list entry_list.inc. Kinds, for painted.cpp:
//     ticked      a query: made, then run slice by slice
//     translated  the same, but only with poses that do not rotate
//     asked       one call, one answer
#include "proofs/stack/entry_headers.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using stack_proof::Arguments;
using stack_proof::as;
using stack_proof::make_in;

namespace entries {

/// Not inlined: its frame is gone when a slice runs.
template <class Asked>
[[gnu::noinline]] void make_query(Arguments& in, const typename Asked::Mesh& a,
                                  const typename Asked::Mesh& b) {
  make_in<Asked>(in.query, [&] {
    if constexpr (__is_constructible(typename Asked::Cursor)) {
      return Asked(a, b, *in.pose);
    } else {  // the array of pairs that traversals with a stack have
      return Asked(a, b, *in.pose, typename Asked::Cursor(in.stack, stack_proof::kStackEntries));
    }
  });
}

/// None, and some that are far from what is nearest, which the walk then finds.
constexpr uint16_t kSeeds = 5;
inline Witness<uint16_t> seed_of(uint16_t i) {
  const auto at = static_cast<uint16_t>(3 * i - 3);
  return i == 0 ? Witness<uint16_t>() : Witness<uint16_t>{at, at};
}

/// Of the first triangles each with each.
constexpr uint16_t kMostPairs = 100;
inline Witness<uint16_t> pair_of(uint16_t i) {
  return {static_cast<uint16_t>(i / 10), static_cast<uint16_t>(i % 10)};
}

[[gnu::noinline]] inline void make_clearance(Arguments& in, const Witness<uint16_t>& seed) {
  make_in<ClearanceQuery>(in.query, [&] { return ClearanceQuery(*in.a, *in.b, *in.pose, seed); });
}
[[gnu::noinline]] inline void make_within(Arguments& in) {
  make_in<WithinQuery>(
      in.query, [&] { return WithinQuery(*in.a, *in.b, *in.pose, {}, within(in.distance)); });
}
[[gnu::noinline]] inline void start_clearance(Arguments& in, const flashbvh_witness* seed) {
  in.ends(flashbvh_clearance_start(&as<flashbvh_clearance_query>(in.query), in.c_a, in.c_b,
                                   in.c_pose, seed, 0));
}

[[gnu::noinline]] inline void start_within(Arguments& in) {
  in.ends(flashbvh_within_start(&as<flashbvh_within_query>(in.query), in.c_a, in.c_b, in.c_pose,
                                in.distance));
}

/// Makes the query if no work is granted, else runs it for a slice.
template <class Asked>
[[gnu::always_inline]] inline void make_or_run(Arguments& in, const typename Asked::Mesh& a,
                                               const typename Asked::Mesh& b) {
  if (in.work == 0) {
    make_query<Asked>(in, a, b);
    return;
  }
  const Step step = as<Asked>(in.query).run(in.work, in.found, in.capacity);
  in.answer += step.count;
  in.status = static_cast<uint8_t>(step.status);
}

/// A visitor that takes no stack.
inline bool count_visit(flashbvh_pair /*pair*/, void* context) {
  ++*static_cast<uint32_t*>(context);
  return true;
}

// A function if the source has `#define CHOSEN_NAME ~, extern "C" void`, else a template that
// nobody instantiates.
#define SECOND(first, second, ...) second
#define LINKAGE(...) SECOND(__VA_ARGS__, template <class Arguments> void, ~)
#define ENTRY(name, kind) LINKAGE(CHOSEN_##name) name(Arguments* in)
#define QUERY(name, kind, a, b, ...)                      \
  ENTRY(name, kind) {                                     \
    make_or_run<Query<__VA_ARGS__>>(*in, *in->a, *in->b); \
  }

// All of one exact query under any rigid pose, by each traversal.
QUERY(rigid_query, ticked, a, b, Ranked<PostMesh>)
// The same; painted.cpp asks it with poses that only translate, and calls.txt leaves the rotating
// walk out of its call graph.
QUERY(translated_query, translated, a, b, Ranked<PostMesh>)
QUERY(stackless_query, ticked, pre_a, pre_b, Stackless)
QUERY(stackless_post_query, ticked, a, b, StacklessPost)
QUERY(leaf_query, ticked, pre_a, pre_b, Leaf<PreMesh>)
QUERY(volume_stack_query, ticked, pre_a, pre_b, VolumeStack<PreMesh>)
QUERY(alternating_stack_query, ticked, a, b, AlternatingStack<LevelledPostMesh>)
QUERY(ranked_stack_query, ticked, a, b, RankedStack<PostMesh>)

// A query in C: started if no work is granted, else run for a slice.
ENTRY(c_query, ticked) {
  auto* const query = &as<flashbvh_query>(in->query);
  if (in->work == 0) {
    in->ends(flashbvh_query_start(query, in->c_a, in->c_b, in->c_pose));
    return;
  }
  uint32_t count = 0;
  in->ends(flashbvh_query_run(query, in->work, in->c_found(), in->capacity, &count));
  in->answer += count;
}

// One traversal of boxes, translated and not rotated, without triangles.
ENTRY(translated_walk, asked) {
  const TranslatedBound& overlap = as<TranslatedBound>(in->made_pose);
  uint32_t leaf_pairs = 0;
  auto leaf_pair = [&leaf_pairs](uint32_t, uint32_t, const Progress&) {
    ++leaf_pairs;
    return true;
  };
  NoShapes<PostMesh> shapes = {*in->a, *in->b};
  WalkRun<PairCursor<uint16_t>, decltype(leaf_pair)> run(in->stack[0], leaf_pair, in->work);
  (void)walk<Ranked<PostMesh>>(overlap, shapes, run, State::fresh);
  in->answer = leaf_pairs + run.progress.overlaps;
}

// A made query taken to a position.
ENTRY(resume, asked) {
  auto& query = as<PairQuery>(in->query);
  in->ends(query.resume(in->position));
}

// The triangles of the pair that a query reported last.
ENTRY(last_pair, asked) {
  const auto& query = as<PairQuery>(in->query);
  query.last_pair(in->transformed[0], in->transformed[1]);
}

// The triangles of a reported pair, transformed again by their ids.
ENTRY(transform_a_pair, asked) {
  in->answer = transform_pair<PostMesh>(*in->a, *in->b, *in->pose, in->found[0], in->transformed[0],
                                        in->transformed[1])
                   ? 1u
                   : 0u;
}

// Queries about distance, which lie elsewhere.
ENTRY(clearance_run, asked) {
  for (uint16_t i = 0; i < kSeeds; ++i) {
    make_clearance(*in, seed_of(i));
    in->ends(as<ClearanceQuery>(in->query).run(UINT32_MAX));
  }
}

ENTRY(clearance_result, asked) {
  make_clearance(*in, {0, 0});
  new (InPlace{&in->clearance}) Clearance<uint16_t>(as<ClearanceQuery>(in->query).result());
}

ENTRY(clearance_resume, asked) {
  for (uint16_t i = 0; i < kMostPairs; ++i) {
    make_clearance(*in, pair_of(i));
    in->clearance_position = {{}, pair_of(i), true};
    in->ends(as<ClearanceQuery>(in->query).resume(in->clearance_position));
  }
}

ENTRY(within_run, asked) {
  make_within(*in);
  in->ends(as<WithinQuery>(in->query).run(UINT32_MAX, [in](const WithinQuery::Pair&) {
    ++in->answer;
    return true;
  }));
}

// Meshes that bend. None of their vertices is out of the lattice.
ENTRY(refit, asked) {
  in->ends(in->bent->refit().status);
}

/// Of a mesh that bends, against itself.
template <class Asked, class... Question>
[[gnu::always_inline]] inline void ask_itself(Arguments& in, const Question&... question) {
  const auto make = [&]() __attribute__((noinline)) {
    make_in<Asked>(in.query, [&] { return Asked(*in.bent, question...); });
  };
  make();
  in.ends(as<Asked>(in.query).run(UINT32_MAX, [&in](const typename Asked::Pair&) {
    ++in.answer;
    return true;
  }));
}

ENTRY(self_run, asked) {
  ask_itself<DeformableQuery<SelfQuery>>(*in);
}

ENTRY(self_within_run, asked) {
  ask_itself<DeformableQuery<SelfWithinQuery>>(*in, within(in->distance));
}

ENTRY(closer_than_once, asked) {
  const Answer answer = closer_than<uint16_t>(*in->a, *in->b, *in->pose, in->distance);
  in->answer = answer.yes ? 1 : 0;
  in->ends(answer.status);
}

ENTRY(distance_once, asked) {
  new (InPlace{&in->clearance}) Clearance<uint16_t>(distance<uint16_t>(*in->a, *in->b, *in->pose));
}

// The robot's layer.
ENTRY(guard_update, asked) {
  constexpr JointCoordinate values[1] = {0};
  auto& guard = make_in<Guard>(in->query, [&] { return Guard(*in->robot, *in->guard_state); });
  in->ends(guard.update(values, UINT32_MAX).status);
}

ENTRY(guard_explain, asked) {
  constexpr JointCoordinate values[1] = {0};
  int32_t changes[1];
  auto& guard = make_in<Guard>(in->query, [&] { return Guard(*in->robot, *in->guard_state); });
  in->ends(guard.update(values, UINT32_MAX).status);
  in->answer += guard.explain(0, changes).nearest.upper;
}

ENTRY(workcell_add, asked) {
  Workcell cell(*in->robot, *in->workcell_memory);
  uint8_t tool = 0;
  uint8_t obstacle = 0;
  in->ends(cell.add(*in->a, {0, kIdentityFrame}, tool));
  in->ends(cell.add(*in->a, {kBase, kIdentityFrame}, obstacle));
  in->ends(cell.keep_apart(tool, obstacle, 0, 0));
  in->ends(cell.move(obstacle, kIdentityFrame, 1));
}

ENTRY(motion_run, asked) {
  constexpr JointCoordinate from[1] = {-(1 << 20)};
  constexpr JointCoordinate to[1] = {1 << 20};
  auto& motion =
      make_in<MotionQuery>(in->query, [&] { return MotionQuery(*in->robot, *in->motion_state); });
  (void)motion.start(from, to);
  in->ends(motion.run(UINT32_MAX).status);
}

// Solids.
ENTRY(inside_once, asked) {
  for (int32_t i = 0; i < 162; ++i) {
    const Point point = {4000 * (i % 9) - 16000, 4000 * (i / 9 % 9) - 16000, i < 81 ? 0 : -500};
    in->answer += static_cast<uint32_t>(inside<uint16_t>(*in->closed, point).side);
  }
}

ENTRY(one_is_inside_once, asked) {
  const Answer answer = one_is_inside<uint16_t>(*in->closed, *in->closed, *in->pose);
  in->answer = answer.yes ? 1 : 0;
  in->ends(answer.status);
}

ENTRY(solids_intersect_once, asked) {
  const Answer answer = solids_intersect<uint16_t>(*in->closed, *in->closed, *in->pose);
  in->answer = answer.yes ? 1 : 0;
  in->ends(answer.status);
}

// Rays: from nine places along nine directions, and in the planes of triangles.
inline Segment any_segment(const PostMesh& mesh, uint32_t i) {
  if (i < 81) {
    const auto at = static_cast<int32_t>(i);
    return {{4000 * (at % 9) - 16000, 20000, 0}, {4000 * (at / 9) - 16000, -20000, 300}};
  }
  const auto& corner = mesh.triangles[i % mesh.triangle_count].corner;
  const Vertex& u = mesh.vertices[corner[i % 3]];
  const Vertex& v = mesh.vertices[corner[(i + 1) % 3]];
  const Vertex& w = mesh.vertices[corner[(i + 2) % 3]];
  const int32_t* const o = mesh.origin;
  return {{o[0] + 2 * u.x - v.x, o[1] + 2 * u.y - v.y, o[2] + 2 * u.z - v.z},
          {o[0] + 2 * w.x - u.x, o[1] + 2 * w.y - u.y, o[2] + 2 * w.z - u.z}};
}

ENTRY(nearest_hit_once, asked) {
  for (uint32_t i = 0; i < 162; ++i) {
    const auto found = nearest_hit<uint16_t>(*in->closed, any_segment(*in->closed, i));
    in->answer += found.yes ? found.hit.triangle : 0;
  }
}

ENTRY(signed_crossings_once, asked) {
  for (uint32_t i = 0; i < 162; ++i) {
    in->answer += static_cast<uint32_t>(
        signed_crossings<uint16_t>(*in->closed, any_segment(*in->closed, i)).outwards + 9);
  }
}

ENTRY(segment_of_floats, asked) {
  const float(&origin)[3] = *reinterpret_cast<const float(*)[3]>(in->floats);
  const float(&direction)[3] = *reinterpret_cast<const float(*)[3]>(in->floats + 3);
  in->ends(segment_of(origin, direction, 100, 1).status);
}

// One call, the query on its stack.
ENTRY(intersects_once, asked) {
  const Answer answer = intersects<uint16_t>(*in->a, *in->b, *in->pose);
  in->answer = answer.yes ? 1 : 0;
  in->ends(answer.status);
}

ENTRY(first_pair_once, asked) {
  const Answer answer = first_pair<uint16_t>(*in->a, *in->b, *in->pose, in->found[0]);
  in->answer = answer.yes ? 1 : 0;
  in->ends(answer.status);
}

// The visitor is inlined.
ENTRY(for_each_pair_once, asked) {
  in->ends(for_each_pair<uint16_t>(*in->a, *in->b, *in->pose, [in](const PairQuery::Pair& pair) {
    in->found[in->answer++ % 4] = pair;
    return true;
  }));
}

ENTRY(count_pairs_once, asked) {
  const PairCount count = count_pairs<uint16_t>(*in->a, *in->b, *in->pose);
  in->answer = count.pairs;
  in->ends(count.status);
}

ENTRY(find_pairs_once, asked) {
  const PairCount count = find_pairs<uint16_t>(*in->a, *in->b, *in->pose, in->found, in->capacity);
  in->answer = count.pairs;
  in->ends(count.status);
}

// triangles_intersect(): the exact test alone.
ENTRY(intersect_triangles, asked) {
  in->answer = triangles_intersect(in->triangles[0], in->triangles[1]) ? 1 : 0;
}

ENTRY(contact, asked) {
  new (InPlace{&in->contact}) Contact(contact_of(in->triangles[0], in->triangles[1]));
}

// open_image(): every check of a post-indexed image.
ENTRY(open_an_image, asked) {
  in->ends(open_image(in->image, in->image_size, as<PostMesh>(in->opened)));
}

ENTRY(open_a_robot, asked) {
  in->ends(open_robot(in->robot_image, in->robot_image_size, in->robot_meshes,
                      stack_proof::kRobotLinks, as<Robot>(in->opened)));
}

ENTRY(check_a_tree, asked) {
  in->ends(check_tree(*in->a, as<TreeShape>(in->opened)));
}

ENTRY(pose_rigid, asked) {
  make_in<Pose>(in->made_pose, [&] {
    const auto& rotation = *reinterpret_cast<const int32_t(*)[3][3]>(in->rotation);
    const auto& cells = *reinterpret_cast<const int32_t(*)[3]>(in->cells);
    return Pose::rigid(rotation, cells, *reinterpret_cast<const int16_t(*)[3]>(in->fraction));
  });
}

ENTRY(pose_composed, asked) {
  make_in<Pose>(in->made_pose, [&] { return Pose::composed(*in->pose, *in->other_pose); });
}

ENTRY(pose_inverse, asked) {
  make_in<Pose>(in->made_pose, [&] { return in->pose->inverse(); });
}

// Pose::relative(): what a moving robot needs.
ENTRY(pose_relative, asked) {
  make_in<Pose>(in->made_pose, [&] { return Pose::relative(*in->pose, *in->other_pose); });
}

ENTRY(pose_of_matrix, asked) {
  make_in<Pose>(in->made_pose,
                [&] { return pose_of(*reinterpret_cast<const float(*)[3][4]>(in->floats), 1.0f); });
}

ENTRY(pose_of_quaternion, asked) {
  make_in<Pose>(in->made_pose, [&] {
    const float* const f = in->floats;
    return pose_of(UnitQuaternion{f[0], f[1], f[2], f[3]},
                   *reinterpret_cast<const float(*)[3]>(f + 4), 1.0f);
  });
}

ENTRY(c_open, asked) {
  in->ends(flashbvh_open(in->image, in->image_size, &as<flashbvh_mesh>(in->opened)));
}

ENTRY(c_resume, asked) {
  in->ends(flashbvh_query_resume(&as<flashbvh_query>(in->query), &in->c_position));
}

ENTRY(c_last_pair, asked) {
  flashbvh_query_last_pair(&as<flashbvh_query>(in->query),
                           reinterpret_cast<flashbvh_triangle*>(&in->transformed[0]),
                           reinterpret_cast<flashbvh_triangle*>(&in->transformed[1]));
}

ENTRY(c_visit, asked) {
  in->ends(
      flashbvh_query_visit(&as<flashbvh_query>(in->query), &in->work, count_visit, &in->answer));
}

ENTRY(c_clearance_run, asked) {
  for (uint16_t i = 0; i < kSeeds; ++i) {
    const flashbvh_witness seed = {seed_of(i).a, seed_of(i).b};
    start_clearance(*in, i == 0 ? nullptr : &seed);
    uint32_t work = UINT32_MAX;
    in->ends(flashbvh_clearance_spend(&as<flashbvh_clearance_query>(in->query), &work));
  }
}

ENTRY(c_clearance_result, asked) {
  in->c_clearance_position = {{0, 0, 0, 0, {0, 0, 0}}, {0, 0}, true};
  start_clearance(*in, &in->c_clearance_position.witness);
  flashbvh_clearance_result(&as<flashbvh_clearance_query>(in->query), &in->c_clearance);
  in->ends(Status::done);
}

ENTRY(c_clearance_resume, asked) {
  for (uint16_t i = 0; i < kMostPairs; ++i) {
    const flashbvh_witness pair = {pair_of(i).a, pair_of(i).b};
    start_clearance(*in, &pair);
    in->c_clearance_position = {{0, 0, 0, 0, {0, 0, 0}}, pair, true};
    in->ends(flashbvh_clearance_resume(&as<flashbvh_clearance_query>(in->query),
                                       &in->c_clearance_position));
  }
}

ENTRY(c_distance, asked) {
  in->ends(flashbvh_distance(in->c_a, in->c_b, in->c_pose, nullptr, &in->c_clearance));
}

ENTRY(c_closer_than, asked) {
  bool yes = false;
  in->ends(flashbvh_closer_than(in->c_a, in->c_b, in->c_pose, in->distance, &yes));
  in->answer = yes ? 1 : 0;
}

ENTRY(c_refit, asked) {
  in->ends(flashbvh_deformable_refit(in->c_bent, UINT32_MAX, &in->answer));
}

ENTRY(c_self_run, asked) {
  auto& query = as<flashbvh_self_query>(in->query);
  uint32_t count = 0;
  in->ends(flashbvh_self_query_start(&query, in->c_bent));
  do {
    in->ends(flashbvh_self_query_run(&query, UINT32_MAX, in->c_found(), in->capacity, &count));
    in->answer += count;
  } while (count == in->capacity);
}

ENTRY(c_self_within_run, asked) {
  auto& query = as<flashbvh_self_within_query>(in->query);
  uint32_t count = 0;
  in->ends(flashbvh_self_within_start(&query, in->c_bent, in->distance));
  do {
    in->ends(flashbvh_self_within_run(&query, UINT32_MAX, in->c_found(), in->capacity, &count));
    in->answer += count;
  } while (count == in->capacity);
}

ENTRY(c_within_run, asked) {
  start_within(*in);
  uint32_t count = 0;
  do {
    in->ends(flashbvh_within_run(&as<flashbvh_within_query>(in->query), UINT32_MAX, in->c_found(),
                                 in->capacity, &count));
    in->answer += count;
  } while (count == in->capacity);
}

ENTRY(c_within_visit, asked) {
  start_within(*in);
  in->work = UINT32_MAX;
  in->ends(flashbvh_within_visit(&as<flashbvh_within_query>(in->query), &in->work, count_visit,
                                 &in->answer));
}

ENTRY(c_within_last_nearest_points, asked) {
  auto& query = as<flashbvh_within_query>(in->query);
  uint32_t count = 0;
  start_within(*in);
  in->ends(flashbvh_within_run(&query, UINT32_MAX, in->c_found(), 1, &count));
  if (count != 0) {
    flashbvh_within_last_nearest_points(&query, &in->c_nearest);
  }
}

ENTRY(c_for_each_within, asked) {
  in->ends(flashbvh_for_each_within(in->c_a, in->c_b, in->c_pose, in->distance, count_visit,
                                    &in->answer));
}

ENTRY(c_inside, asked) {
  for (int32_t i = 0; i < 162; ++i) {
    const flashbvh_point point = {4000 * (i % 9) - 16000, 4000 * (i / 9 % 9) - 16000,
                                  i < 81 ? 0 : -500};
    flashbvh_point_side side = FLASHBVH_POINT_OUTSIDE;
    in->ends(flashbvh_inside(in->c_closed, &point, &side));
    in->answer += static_cast<uint32_t>(side);
  }
}

inline flashbvh_segment any_c_segment(const PostMesh& mesh, uint32_t i) {
  const Segment segment = any_segment(mesh, i);
  return {{segment.from.x, segment.from.y, segment.from.z},
          {segment.to.x, segment.to.y, segment.to.z}};
}

ENTRY(c_nearest_hit, asked) {
  for (uint32_t i = 0; i < 162; ++i) {
    const flashbvh_segment segment = any_c_segment(*in->closed, i);
    bool yes = false;
    flashbvh_hit hit;
    in->ends(flashbvh_nearest_hit(in->c_closed, &segment, FLASHBVH_NO_SEED, &yes, &hit));
    in->answer += yes ? hit.triangle : 0;
  }
}

ENTRY(c_signed_crossings, asked) {
  for (uint32_t i = 0; i < 162; ++i) {
    const flashbvh_segment segment = any_c_segment(*in->closed, i);
    int32_t outwards = 0;
    in->ends(flashbvh_signed_crossings(in->c_closed, &segment, &outwards));
    in->answer += static_cast<uint32_t>(outwards + 9);
  }
}

ENTRY(c_segment_of, asked) {
  flashbvh_segment segment;
  in->ends(flashbvh_segment_of(in->floats, in->floats + 3, 100, 1, &segment));
}

ENTRY(c_one_is_inside, asked) {
  bool yes = false;
  in->ends(flashbvh_one_is_inside(in->c_closed, in->c_closed, in->c_pose, &yes));
  in->answer = yes ? 1 : 0;
}

ENTRY(c_solids_intersect, asked) {
  bool yes = false;
  in->ends(flashbvh_solids_intersect(in->c_closed, in->c_closed, in->c_pose, &yes));
  in->answer = yes ? 1 : 0;
}

// The largest shape, of boxes of every size.
ENTRY(c_box_shape, asked) {
  for (int32_t i = 0; i < 13; ++i) {
    const flashbvh_point lower = {-(1 << i), -(3 << i), 0};
    const flashbvh_point upper = {1 << i, 2 << i, i};
    in->ends(flashbvh_box_shape_make(&in->c_box, in->c_a, &lower, &upper));
  }
}

ENTRY(c_transform_pair, asked) {
  const bool found =
      flashbvh_transform_pair(in->c_a, in->c_b, in->c_pose, in->c_found()[0],
                              reinterpret_cast<flashbvh_triangle*>(&in->transformed[0]),
                              reinterpret_cast<flashbvh_triangle*>(&in->transformed[1]));
  in->answer = found ? 1 : 0;
}

ENTRY(c_contact, asked) {
  flashbvh_contact_of(reinterpret_cast<const flashbvh_triangle*>(&in->triangles[0]),
                      reinterpret_cast<const flashbvh_triangle*>(&in->triangles[1]),
                      &in->c_contact);
}

ENTRY(c_last_contact, asked) {
  flashbvh_query_last_contact(&as<flashbvh_query>(in->query), &in->c_contact);
}

ENTRY(in_millionths, asked) {
  in->millionths = millionths_of(in->contact.ends[0].x, in->a->cell_bits);
}

ENTRY(c_in_unit, asked) {
  flashbvh_in_unit(&in->c_contact.ends[0], in->c_a, in->lengths);
}

ENTRY(c_intersects, asked) {
  bool yes = false;
  in->ends(flashbvh_intersects(in->c_a, in->c_b, in->c_pose, &yes));
  in->answer = yes ? 1 : 0;
}

ENTRY(c_first_pair, asked) {
  bool yes = false;
  in->ends(flashbvh_first_pair(in->c_a, in->c_b, in->c_pose, &yes, in->c_found()));
  in->answer = yes ? 1 : 0;
}

ENTRY(c_count_pairs, asked) {
  in->ends(flashbvh_count_pairs(in->c_a, in->c_b, in->c_pose, &in->answer));
}

ENTRY(c_find_pairs, asked) {
  in->ends(
      flashbvh_find_pairs(in->c_a, in->c_b, in->c_pose, in->c_found(), in->capacity, &in->answer));
}

ENTRY(c_for_each_pair, asked) {
  in->ends(flashbvh_for_each_pair(in->c_a, in->c_b, in->c_pose, count_visit, &in->answer));
}

ENTRY(c_pose_rigid, asked) {
  in->ends(flashbvh_pose_rigid(in->rotation[0], in->cells, in->fraction,
                               &as<flashbvh_pose>(in->made_pose)));
}

ENTRY(c_pose_of_matrix, asked) {
  in->ends(flashbvh_pose_of_matrix(in->rigid_floats, in->rigid_floats + 9, 1.0f,
                                   &as<flashbvh_pose>(in->made_pose)));
}

ENTRY(c_pose_of_quaternion, asked) {
  (void)flashbvh_pose_of_quaternion(in->floats, in->floats + 4, 1.0f,
                                    &as<flashbvh_pose>(in->made_pose));
}

ENTRY(c_pose_composed, asked) {
  in->ends(flashbvh_pose_composed(in->c_pose, in->c_other_pose, &as<flashbvh_pose>(in->made_pose)));
}

ENTRY(c_pose_inverse, asked) {
  in->ends(flashbvh_pose_inverse(in->c_pose, &as<flashbvh_pose>(in->made_pose)));
}

ENTRY(c_pose_relative, asked) {
  in->ends(flashbvh_pose_relative(in->c_pose, in->c_other_pose, &as<flashbvh_pose>(in->made_pose)));
}

}  // namespace entries
