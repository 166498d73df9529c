// Explicit instantiation of deformable meshes.
#include "flashbvh/deformable.hpp"

namespace flashbvh {

template class BasicDeformableMesh<Mesh>;
template class BasicDeformableMesh<Mesh32>;

}  // namespace flashbvh
