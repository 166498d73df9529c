// Reproducible randomness for tests: the same numbers on every host and core.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

namespace flashbvh::test {

/// The splitmix64 generator: any seed is good, and equal seeds give equal sequences.
///
/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// 64 bits, each as likely set as not.
  uint64_t next() {
    uint64_t bits = (state_ += 0x9E3779B97F4A7C15u);
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
  }

  /// A number in [0, n), n > 0. Uneven by at most n parts in 2^32.
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(((next() >> 32) * n) >> 32); }

  /// A number in [lo, hi], lo <= hi, hi - lo < 2^32 - 1.
  int32_t between(int32_t lo, int32_t hi) {
    const uint32_t count = static_cast<uint32_t>(hi) - static_cast<uint32_t>(lo) + 1;
    return static_cast<int32_t>(static_cast<int64_t>(lo) + below(count));
  }

  /// A random element.
  template <class Element, size_t count>
  const Element& one_of(const Element (&list)[count]) {
    return list[below(count)];
  }
  template <class List>
  const auto& one_of(const List& list) {
    return list[below(static_cast<uint32_t>(list.size()))];
  }

 private:
  uint64_t state_;
};

/// An environment variable; nullptr if unset, and always on a board.
inline const char* setting(const char* name) {
#if defined(FLASHBVH_ON_BOARD)
  (void)name;
  return nullptr;
#else
  return getenv(name);
#endif
}

/// An environment variable's number; `usual` if unset, and always on a board.
inline long number_in(const char* name, long usual) {
  const char* const text = setting(name);
  return text != nullptr ? static_cast<long>(strtoull(text, nullptr, 0)) : usual;
}

/// Whether FLASHBVH_THOROUGH is set: random tests run all their rounds.
inline bool is_thorough() {
  return setting("FLASHBVH_THOROUGH") != nullptr;
}

/// The rounds of a random test: `few`, or `many` if thorough.
template <class Count>
Count rounds(Count few, Count many) {
  return is_thorough() ? many : few;
}

/// A divisor of the number of rounds: `share` on a board, else 1.
constexpr int share_on_board([[maybe_unused]] int share) {
#if defined(FLASHBVH_ON_BOARD)
  return share;
#else
  return 1;
#endif
}

/// The seed of this run: FLASHBVH_SEED, decimal or 0x hexadecimal, or a fixed one if unset.
inline uint64_t test_seed() {
  const char* const text = setting("FLASHBVH_SEED");
  return text != nullptr ? strtoull(text, nullptr, 0) : 20240607u;
}

/// The random numbers of a test case; each test case of a file has its own `stream`. The seed alone
/// replays a failure.
inline Random test_random(uint64_t stream = 0) {
  return Random(test_seed() + stream);
}

}  // namespace flashbvh::test
