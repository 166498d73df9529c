// The default queries, compiled once.
#include "flashbvh/query.hpp"

namespace flashbvh {

template class Query<Ranked<PostMesh>>;
template class Query<Ranked<LargePostMesh>>;

}  // namespace flashbvh
