// Digest of all answers of a known-answer test.
#ifndef FLASHBVH_SELF_TEST_ANSWER_DIGEST_HPP
#define FLASHBVH_SELF_TEST_ANSWER_DIGEST_HPP

#include <stdint.h>

#include "flashbvh/detail/lattice/checksum.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh::detail {

/// Digest of all answers, in order, and of their work.
class AnswerDigest {
 public:
  void add(uint32_t word) { value_ = with_word(value_, word); }
  void add(uint32_t low, uint32_t high) { add(low | high << 16); }
  uint32_t value() const { return value_; }

 private:
  uint32_t value_ = kNoWords;
};

constexpr Status passed(uint32_t digest, uint32_t known) {
  return digest == known ? Status::done : Status::self_test_failed;
}

}  // namespace flashbvh::detail

#endif
