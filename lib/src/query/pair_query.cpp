// Explicit instantiation of the default queries.
#include "flashbvh/query.hpp"

namespace flashbvh {

template class detail::QueryRun<Ranked<Mesh>, detail::Intersection>;
template class detail::QueryRun<Ranked<Mesh32>, detail::Intersection>;
template class Query<Ranked<Mesh>>;
template class Query<Ranked<Mesh32>>;

}  // namespace flashbvh
