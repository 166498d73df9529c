// All public templates and inline functions without an entry, compiled once: check_symbols.cmake
// checks their calls and data, even if they are unused.
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/solid.hpp"
#include "flashbvh/traversal/traversals.hpp"

namespace flashbvh {

// The stackless traversals, with all their members; those with a stack have no cursors to keep.
template class Query<Ranked<Mesh>>;
template class Query<Ranked<Mesh32>>;
template class Query<Ranked<Mesh>, Within>;
template class BasicClearanceQuery<Mesh>;
template class BasicClearanceQuery<Mesh32>;
template class BasicDeformableMesh<Mesh>;
template class BasicDeformableMesh<PreMeshWithLevels>;
template class BasicSelfQuery<Mesh, detail::Intersection>;
template class BasicSelfQuery<Mesh, Within>;
template class DeformableQuery<PairQuery>;
template class DeformableQuery<SelfQuery>;
template class DeformableQuery<ClearanceQuery>;
template class Query<Stackless>;
template class Query<StacklessPost>;
template class Query<Leaf>;
template class Query<LeafPost>;

namespace test {

template <class Traversal>
Status run(const typename Traversal::Tree& a, const typename Traversal::Tree& b, const Pose& pose,
           typename Traversal::Cursor& start, Contact& contact) {
  typename Query<Traversal>::Pair found[2];
  Query<Traversal> query(a, b, pose, start);
  const Status status = query.run(100, found).status;
  contact = contact_of_last(query);
  return status;
}

#define FLASHBVH_TEST_RUN(traversal)                                                          \
  template Status run<traversal>(const traversal::Tree&, const traversal::Tree&, const Pose&, \
                                 traversal::Cursor&, Contact&)
FLASHBVH_TEST_RUN(VolumeStack);
FLASHBVH_TEST_RUN(VolumeStackPost);
FLASHBVH_TEST_RUN(AlternatingStack);
FLASHBVH_TEST_RUN(AlternatingStackPost);
FLASHBVH_TEST_RUN(Ranked<Mesh>);
FLASHBVH_TEST_RUN(Ranked<Mesh32>);

/// The queries of collide.hpp and contact.hpp.
template <class TreeType>
uint32_t run_queries(const TreeType& a, const TreeType& b, const Pose& pose) {
  using Pair = TrianglePair<typename TreeType::Index>;
  Pair found[2];
  Triangle transformed[2];
  uint32_t sum = intersects(a, b, pose).yes ? 1u : 0u;
  sum += first_pair(a, b, pose, found[0]).yes ? 1u : 0u;
  Witness<typename TreeType::Index> hint;
  sum += intersects(a, b, pose, hint).yes ? 1u : 0u;
  sum += count_pairs(a, b, pose).count + find_pairs(a, b, pose, found, 2).count;
  (void)for_each_pair(a, b, pose, [&sum](const Pair& pair) { return (sum += pair.a) != 0; });
  return sum + (transform_pair(a, b, pose, found[0], transformed[0], transformed[1]) ? 1u : 0u);
}
template uint32_t run_queries(const Mesh&, const Mesh&, const Pose&);
template uint32_t run_queries(const Mesh32&, const Mesh32&, const Pose&);

Pose pose_of_matrix(const float (&rotation)[3][3], const float (&translation)[3], float scale) {
  return pose_of(rotation, translation, scale);
}

}  // namespace test
}  // namespace flashbvh
