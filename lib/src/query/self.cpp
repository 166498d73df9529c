// Explicit instantiation of queries of a mesh against itself.
#include "flashbvh/self.hpp"

namespace flashbvh {

FLASHBVH_COMPILED_QUERY_RUN(, detail::SelfRanked<Mesh>,
                            detail::SelfPredicate<detail::Intersection>);
FLASHBVH_COMPILED_QUERY_RUN(, detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>);
template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<detail::Intersection>>;
template class Query<detail::SelfRanked<Mesh>, detail::SelfPredicate<Within>>;

}  // namespace flashbvh
