// The functions of the library's headers, compiled once, for the proofs of their symbols, their
// code and their stack (stack.txt).
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/self.hpp"
#include "proofs/stack/painted.hpp"

namespace flashbvh {

// What a caller stores.
static_assert(sizeof(PairQuery) <= 128 && sizeof(QueryCursor<uint16_t>) == 12);
static_assert(sizeof(ClearanceQuery) <= 160 && sizeof(WithinQuery) <= 160);
static_assert(sizeof(Pose) <= 68 && sizeof(Mesh) <= 72 && sizeof(Contact) <= 104);
static_assert(sizeof(FirstContact) <= 80 && sizeof(BodyMotion) <= 192);

// One call for each query.
template Answer intersects(const Mesh&, const Mesh&, const Pose&);
template Answer intersects(const Mesh&, const Mesh&, const Pose&, Witness<uint16_t>&);
template Answer first_pair(const Mesh&, const Mesh&, const Pose&, PairQuery::Pair&);
template RunResult count_pairs(const Mesh&, const Mesh&, const Pose&);
template RunResult find_pairs(const Mesh&, const Mesh&, const Pose&, PairQuery::Pair*, uint32_t);
template Answer closer_than(const Mesh&, const Mesh&, const Pose&, FineLength);
template Clearance<uint16_t> distance(const Mesh&, const Mesh&, const Pose&,
                                      const Witness<uint16_t>&);
template bool transform_pair(const Mesh&, const Mesh&, const Pose&, const PairQuery::Pair&,
                             Triangle&, Triangle&);

namespace instance {

// Functions that callers inline. Arguments lie in memory: to store them is the caller's part.
void run_query(PairQuery& query, painted::Scene& scene) {
  scene.step = query.run(scene.work, scene.found);
}
template <class QueryType>
uint32_t count_pairs(QueryType& query) {
  uint32_t count = 0;
  (void)query.run(UINT32_MAX, [&count](const PairQuery::Pair&) { return ++count != 0; });
  return count;
}
template uint32_t count_pairs(WithinQuery&);
template uint32_t count_pairs(SelfQuery&);
template uint32_t count_pairs(SelfWithinQuery&);
Status visit_pairs(const Mesh& a, const Mesh& b, const Pose& pose, uint32_t& sum) {
  return for_each_pair(a, b, pose,
                       [&sum](const PairQuery::Pair& pair) { return (sum += pair.a) != 0; });
}
Pose pose_of_matrix(const float (&matrix)[3][4], float cells_per_unit) {
  return pose_of(matrix, cells_per_unit);
}
Pose pose_of_quaternion(const UnitQuaternion& rotation, const float (&translation)[3],
                        float cells_per_unit) {
  return pose_of(rotation, translation, cells_per_unit);
}
MadeSegment segment_of_floats(const float (&origin)[3], const float (&direction)[3], float reach) {
  return segment_of(origin, direction, reach, 1);
}

}  // namespace instance
}  // namespace flashbvh

void painted_query(void* context) {
  auto& scene = *static_cast<painted::Scene*>(context);
  flashbvh::PairQuery query(*scene.a, *scene.b, *scene.pose);
  do {
    scene.step = query.run(scene.work, scene.found);
  } while (scene.step.status == flashbvh::Status::full);
}

void painted_distance(void* context) {
  auto& scene = *static_cast<painted::Scene*>(context);
  scene.clearance = distance(*scene.a, *scene.b, *scene.pose);
}
