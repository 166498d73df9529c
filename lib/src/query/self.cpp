// Explicit instantiation of queries of a mesh against itself.
#include "flashbvh/self.hpp"

namespace flashbvh {

template class detail::QueryRun<detail::SelfRanked<Mesh>,
                                detail::SelfPredicate<detail::Intersection>>;
template class detail::QueryRun<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;
template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<detail::Intersection>>;
template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;

}  // namespace flashbvh
