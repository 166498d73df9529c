// One query, for a link with the library's sources.
#include "flashbvh/query.hpp"

extern "C" flashbvh::RunResult one_query(const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                                         const flashbvh::Pose& pose,
                                         flashbvh::PairQuery::Pair* found) {
  return flashbvh::PairQuery(a, b, pose).run(UINT32_MAX, found, 1);
}
