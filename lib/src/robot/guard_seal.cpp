// The guard: checksums that detect damaged memory.
#include "flashbvh/robot/guard.hpp"

namespace flashbvh {

using detail::Fit;

namespace {

constexpr uint32_t kNoWords = 2166136261u;

/// Adds a word to a checksum. A rotation, an exclusive or and a product with an odd number are each
/// invertible. So different checksums stay different, and different words make them different: a
/// change of one word is always found. The rotation moves the top bits, which products leave in
/// place.
constexpr uint32_t with_word(uint32_t checksum, uint32_t word) {
  return ((checksum << 7 | checksum >> 25) ^ word) * 0x9E3779B1u;
}

/// Continues a checksum over whole words.
[[gnu::noinline]] uint32_t checksum_of(const void* begin, const void* end, uint32_t checksum) {
  const auto* const last = static_cast<const unsigned char*>(end);
#pragma GCC unroll 4
  for (const auto* at = static_cast<const unsigned char*>(begin); at < last; at += 4) {
    uint32_t word;
    __builtin_memcpy(&word, __builtin_assume_aligned(at, alignof(uint32_t)), sizeof word);
    checksum = with_word(checksum, word);
  }
  return checksum;
}

}  // namespace

uint32_t Guard::own_checksum() const {
  return checksum_of(this, &seal_, kNoWords);
}

uint32_t Guard::robot_checksum() const {
  return checksum_of(robot_, robot_ + 1, kNoWords);
}

uint32_t Guard::meshes_checksum() const {
  return checksum_of(robot_->meshes, robot_->meshes + robot_->link_count, kNoWords);
}

/// The last word may include bytes of the state's padding.
uint32_t Guard::state_checksum() const {
  return checksum_of(&core_->checksum + 1, walked_shares_ + robot_->joint_count,
                     with_word(core_->version | uint32_t{core_->laps} << 8, core_->robot_hash));
}

void Guard::seal() {
  if (!fits()) {
    return;
  }
  core_->checksum = state_checksum();
  robot_seal_ = robot_checksum();
  meshes_seal_ = meshes_checksum();
  seal_ = own_checksum();
}

/// Checks in an order in which each pointer is checked before it is followed.
Status Guard::verify() const {
  if (fit_ == Fit::not_open && seal_ == 0) {
    return Status::not_open;
  }
  const bool is_intact = seal_ == own_checksum() && fits() && robot_seal_ == robot_checksum() &&
                         meshes_seal_ == meshes_checksum() && core_->checksum == state_checksum();
  return is_intact ? Status::done : Status::guard_state_invalid;
}

}  // namespace flashbvh
