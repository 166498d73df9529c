// Explicit instantiation of searches for one pair; programs seldom need pair_query.cpp, too.
#include "flashbvh/collide.hpp"

namespace flashbvh {

template class detail::QueryRun<detail::NearFirst<Mesh>, detail::Intersection>;
template class detail::QueryRun<detail::NearFirst<Mesh32>, detail::Intersection>;

}  // namespace flashbvh
