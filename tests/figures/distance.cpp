// Distances of the KR5's links in the poses of kr5.cpp: without a hint, and with the witness of a
// pose 10 cells away as a hint. Exits with 1 if the two differ.
#include "flashbvh/clearance.hpp"

#include "measure.hpp"
#include "query_pose.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells

Name part(const char* what, const char* motion) {
  return {{"distance", what, motion}};
}

/// A predicate whose tests are measured if it has a name.
template <class Predicate>
struct Timed : Predicate {
  const Name* name = nullptr;

  bool test(const Triangle& a, const Triangle& b, uint32_t i, uint32_t j) {
    bool yes = false;
    const auto run = [&] { yes = Predicate::test(a, b, i, j); };
    name == nullptr ? run() : static_cast<void>(measure(*name, run));
    return yes;
  }
};

template <class Predicate>
void run_all(const MeshPair& pair, const Pose& pose, const Predicate& question) {
  Query<Ranked<Mesh>, Predicate> query(*pair.a, *pair.b, pose, {}, question);
  (void)query.run(UINT32_MAX, [](const TrianglePair<uint16_t>&) { return true; });
}

/// Tests of pairs of triangles that queries reach: within the distance, and possibly nearer than
/// the nearest pair.
void add_tests(const MeshPair& pair, const Pose& pose, const Clearance<uint16_t>& known,
               const char* motion) {
  const Name of_within = part("within", motion);
  Timed<Within> within;
  static_cast<Within&>(within) = flashbvh::within({known.lower});
  within.name = &of_within;
  run_all(pair, pose, within);

  Transform transform(pose, *pair.a, *pair.b, /*may_stop=*/false);
  Triangle a;
  Triangle b;
  translate_triangle(*pair.a, known.witness.a, kNoOffset, a);
  transform_triangle(*pair.b, known.witness.b, transform, b);
  const Name of_nearest = part("nearest", motion);
  transform.prepare(*pair.b);
  NearestSoFar so_far(transform);
  Timed<Nearest<uint16_t>> nearest;
  nearest.so_far = &so_far;
  (void)nearest.take(a, b);
  nearest.nearest_a = known.witness.a;
  nearest.nearest_b = known.witness.b;
  nearest.name = &of_nearest;
  run_all(pair, pose, nearest);
}

template <class Shapes>
Walked walk_within(const MeshPair& pair, const Transform& transform, const Within& question) {
  const auto no_leaf_pair = [](uint32_t, uint32_t) {};
  Shapes shapes(*pair.a, *pair.b, transform);
  if (question.is_kept(transform)) {
    KeptGap bound = question.kept(transform);
    shapes.set_box_test(bound);
    return measure_walk(ByReference<KeptGap>{&bound}, shapes, no_leaf_pair);
  }
  const TranslatedGap bound = question.translated(transform.translated());
  shapes.set_box_test(bound);
  return measure_walk(bound, shapes, no_leaf_pair);
}

/// Walks without triangle tests, over pairs within the distance.
void add_walks(const MeshPair& pair, const Pose& pose, uint32_t distance, const char* motion) {
  Transform transform(pose, *pair.a, *pair.b, /*may_stop=*/false);
  transform.prepare(*pair.b);
  const Within question = within({distance});
  const Walked all = walk_within<ProximityPlanes<Mesh>>(pair, transform, question);
  const Walked inner = walk_within<NothingBelow>(pair, transform, question);
  add_quotient(part("visit", motion), inner.instructions, inner.visits);
  add_quotient(part("leaf_visit", motion), int64_t{all.instructions} - inner.instructions,
               all.visits - inner.visits);
}

Clearance<uint16_t> add_distance(const FigureNames& names, const char* hint, const MeshPair& pair,
                                 const Pose& pose, const Witness<uint16_t>& seed) {
  ClearanceQuery query(*pair.a, *pair.b, pose, seed);
  (void)query.run(UINT32_MAX);
  add_to_digest(query.stats());
  Clearance<uint16_t> found{};
  measure({{names.set, names.motion, names.proximity, hint}},
          [&] { found = distance(*pair.a, *pair.b, pose, seed); });
  add_to_digest(found.lower);
  add_to_digest(found.upper);
  return found;
}

bool measure_pose(const MeshPair& pair, const QueryPose& query_pose, const char* motion,
                  const char* proximity) {
  const Pose pose = pose_of(query_pose);
  const Clearance<uint16_t> near = distance(*pair.a, *pair.b, pose_of(query_pose, kStep));
  const FigureNames names = {"distance", motion, proximity};
  const Clearance<uint16_t> first = add_distance(names, "cold", pair, pose, {});
  const Clearance<uint16_t> second = add_distance(names, "hint", pair, pose, near.witness);
  if (second.lower != 0 && second.lower <= kMaxDistance) {
    add_tests(pair, pose, second, motion);
    add_walks(pair, pose, second.lower, motion);
  }
  return first.status == Status::done && first.lower == second.lower && first.upper == second.upper;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::print_all("distance", figures::for_each_query_pose(figures::measure_pose));
}
