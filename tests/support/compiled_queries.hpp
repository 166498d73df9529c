// The queries of all traversals, compiled once for all tests (compiled_queries.cpp): the walk and
// the triangle test, which take no sink. The library has those of Ranked.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "flashbvh/traversal/traversals.hpp"
#include "support/ranked_stack.hpp"

#define FLASHBVH_COMPILED_TESTS(keyword, ...) \
  keyword template bool __VA_ARGS__::next_answer(__VA_ARGS__::Batch&, uint32_t)
#define FLASHBVH_COMPILED_RUN(keyword, ...)                                        \
  keyword template detail::State __VA_ARGS__::walk(uint32_t&, __VA_ARGS__::Batch&, \
                                                   typename __VA_ARGS__::Kept::Shapes&, uint32_t)
#define FLASHBVH_COMPILED_QUERY(keyword, ...)                                             \
  FLASHBVH_COMPILED_TESTS(keyword, detail::LeafTests<__VA_ARGS__, detail::Intersection>); \
  FLASHBVH_COMPILED_RUN(keyword, detail::QueryRun<__VA_ARGS__, detail::Intersection>)
#define FLASHBVH_COMPILED_LAYOUT(keyword, Index, layout)                                       \
  FLASHBVH_COMPILED_QUERY(keyword, BasicVolumeStack<BasicMesh<Index, layout>>);                \
  FLASHBVH_COMPILED_QUERY(keyword, BasicAlternatingStack<BasicMeshWithLevels<Index, layout>>); \
  FLASHBVH_COMPILED_QUERY(keyword, BasicStackless<BasicMeshWithLevels<Index, layout>>);        \
  FLASHBVH_COMPILED_QUERY(keyword, BasicLeaf<BasicMesh<Index, layout>>)
/// `keyword`: extern, or nothing.
#define FLASHBVH_COMPILED_QUERIES(keyword, Index)                 \
  FLASHBVH_COMPILED_LAYOUT(keyword, Index, Layout::pre_indexed);  \
  FLASHBVH_COMPILED_LAYOUT(keyword, Index, Layout::post_indexed); \
  FLASHBVH_COMPILED_QUERY(keyword, test::RankedStack<BasicMesh<Index, Layout::post_indexed>>)

namespace flashbvh {

FLASHBVH_COMPILED_QUERIES(extern, uint16_t);
FLASHBVH_COMPILED_QUERIES(extern, uint32_t);

}  // namespace flashbvh
