// Explicit instantiation of the default queries.
#include "flashbvh/query.hpp"

namespace flashbvh {

FLASHBVH_COMPILED_QUERY_RUN(, Ranked<Mesh>, detail::Intersection);
FLASHBVH_COMPILED_QUERY_RUN(, Ranked<Mesh32>, detail::Intersection);
template class Query<Ranked<Mesh>>;
template class Query<Ranked<Mesh32>>;

}  // namespace flashbvh
