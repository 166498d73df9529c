// The default queries, compiled once.
#include "flashbvh/query.hpp"

namespace flashbvh {

template class Query<Ranked<Mesh>>;
template class Query<Ranked<Mesh32>>;

}  // namespace flashbvh
