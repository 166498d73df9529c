// Explicit instantiation of deformable meshes.
#include "flashbvh/deformable.hpp"

namespace flashbvh {

template class BasicDeformableMesh<Mesh>;

}  // namespace flashbvh
