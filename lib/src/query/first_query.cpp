// Searches for one pair, compiled once; apart from pair_query.cpp, as programs seldom need both.
#include "flashbvh/collide.hpp"

namespace flashbvh {

template class detail::QueryRun<detail::NearFirst<Mesh>, detail::Intersection>;
template class detail::QueryRun<detail::NearFirst<Mesh32>, detail::Intersection>;

}  // namespace flashbvh
