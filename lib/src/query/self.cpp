// A mesh against itself, compiled once.
#include "flashbvh/self.hpp"

namespace flashbvh {

template class Query<detail::SelfRanked<PostMesh>, detail::SelfQuestion<detail::Intersection>>;
template class Query<detail::SelfRanked<LargePostMesh>, detail::SelfQuestion<detail::Intersection>>;
template class Query<detail::SelfRanked<PostMesh>, detail::SelfQuestion<Within>>;
template class Query<detail::SelfRanked<LargePostMesh>, detail::SelfQuestion<Within>>;

}  // namespace flashbvh
