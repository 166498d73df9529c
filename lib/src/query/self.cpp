// A mesh against itself, compiled once.
#include "flashbvh/self.hpp"

namespace flashbvh {

template class Query<detail::SelfRanked<Mesh>, detail::SelfQuestion<detail::Intersection>>;
template class Query<detail::SelfRanked<Mesh32>, detail::SelfQuestion<detail::Intersection>>;
template class Query<detail::SelfRanked<Mesh>, detail::SelfQuestion<Within>>;
template class Query<detail::SelfRanked<Mesh32>, detail::SelfQuestion<Within>>;

}  // namespace flashbvh
