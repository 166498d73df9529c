// Refits, compiled once.
#include "flashbvh/deformable.hpp"

namespace flashbvh {

template class BasicDeformableMesh<PostMesh>;
template class BasicDeformableMesh<LargePostMesh>;

}  // namespace flashbvh
