// The loop of random tests, on every board.
#pragma once

#include <catch2/catch.hpp>

#include "support/random.hpp"

namespace flashbvh::test {

/// Calls body(random, round) `count` times, with the random numbers of a stream. A failure reports
/// its round.
template <class Count, class Body>
void for_rounds(Count count, uint64_t stream, const Body& body) {
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
