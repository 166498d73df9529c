// Explicit instantiation of searches for one pair; programs seldom need pair_query.cpp, too.
#include "flashbvh/collide.hpp"

namespace flashbvh {

FLASHBVH_COMPILED_QUERY_RUN(, detail::NearFirst<Mesh>, detail::Intersection);
FLASHBVH_COMPILED_QUERY_RUN(, detail::NearFirst<Mesh32>, detail::Intersection);
template class detail::FirstQuery<uint16_t>;
template class detail::FirstQuery<uint32_t>;

}  // namespace flashbvh
