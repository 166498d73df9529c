// The common includes of tests with a heap.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace flashbvh::test {

/// Calls body(random, round) `count` times, with the random numbers of a stream. A failure reports
/// its round.
template <class Count, class Body>
void for_rounds(Count count, std::uint64_t stream, const Body& body) {
  Random random = test_random(stream);
  for (Count round = 0; round < count; ++round) {
    CAPTURE(round);
    body(random, round);
  }
}
template <class Count, class Body>
void for_rounds(Count count, const Body& body) {
  for_rounds(count, 0, body);
}

}  // namespace flashbvh::test

using namespace flashbvh;
using namespace flashbvh::test;
