// The class templates of the library's headers with all their members, for the proof of their
// symbols.
#include "flashbvh/clearance.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/solid.hpp"
#include "flashbvh/traversal/traversals.hpp"

namespace flashbvh {

// Traversals with a stack have no cursors to keep.
template class Query<Stackless>;
template class Query<StacklessPost>;
template class Query<Leaf>;
template class Query<LeafPost>;
template class BasicDeformableMesh<PreMeshWithLevels>;
template class BasicSelfQuery<Mesh, detail::Intersection>;
template class BasicSelfQuery<Mesh, Within>;
template class DeformableQuery<PairQuery>;
template class DeformableQuery<SelfQuery>;
template class DeformableQuery<ClearanceQuery>;

namespace instance {

template <class Traversal>
Status run(const typename Traversal::Tree& a, const typename Traversal::Tree& b, const Pose& pose,
           typename Traversal::Cursor& start, Contact& contact) {
  typename Query<Traversal>::Pair found[2];
  Query<Traversal> query(a, b, pose, start);
  const Status status = query.run(100, found).status;
  contact = contact_of_last(query);
  return status;
}

#define FLASHBVH_RUN(traversal)                                                               \
  template Status run<traversal>(const traversal::Tree&, const traversal::Tree&, const Pose&, \
                                 traversal::Cursor&, Contact&)
FLASHBVH_RUN(VolumeStack);
FLASHBVH_RUN(VolumeStackPost);
FLASHBVH_RUN(AlternatingStack);
FLASHBVH_RUN(AlternatingStackPost);

}  // namespace instance
}  // namespace flashbvh
