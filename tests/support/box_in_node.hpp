// A packed box with something after it, as in a node: some forms of the overlap tests read that,
// and none may mind it.
#ifndef FLASHBVH_TESTS_SUPPORT_BOX_IN_NODE_HPP
#define FLASHBVH_TESTS_SUPPORT_BOX_IN_NODE_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/box_packed.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

struct BoxInNode {
  detail::PackedBox box;
  uint32_t rest;
};

inline BoxInNode in_node(Random& random, const detail::Box& box) {
  constexpr uint32_t rests[] = {0, 0xFFFF, 0xFFFF0000, 0x80008000, 0x7FFF7FFF, 0xFFFFFFFF};
  return {detail::pack(box), rests[random.below(6)]};
}

}  // namespace flashbvh::test

#endif
