// The joints between two links, and how far they move the links towards each other.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// Calls `visit(joint, reach)` for all joints between two links: a's branch from its own joint
/// inwards, then b's branch. A single loop, so that the code of `visit` is inlined once.
template <class Visit>
FLASHBVH_INLINE inline void for_each_between(const Robot& robot, const RobotPair& pair,
                                             Visit&& visit) {
  uint32_t left = pair.joints_a;
  uint32_t then = pair.joints_b;
  const RobotLink* link = &robot.links[pair.a];
  for (;;) {
    const uint32_t* reach = robot.reaches + link->first_reach;
    uint32_t joint = link->joint;
    for (; left != 0; --left) {
      visit(joint, *reach++);
      joint = robot.joints[joint].parent;
    }
    if (then == 0) {
      return;
    }
    left = then;
    then = 0;
    link = &robot.links[pair.b];
  }
}

inline const Frame& frame_of(const Frame* frames, uint8_t joint) {
  return joint == kBase ? kIdentityFrame : frames[joint];
}

/// Adds lengths; saturates at 32 bits.
constexpr uint32_t sum_of(uint32_t u, uint32_t v) {
  return u > UINT32_MAX - v ? UINT32_MAX : u + v;
}

template <class Length>
constexpr Length difference_of(Length u, Length v) {
  return u > v ? u - v : 0;
}

/// The largest deviation of a link, of which Robot::slack has two.
inline uint32_t largest_deviation(const Robot& robot) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < robot.link_count; ++i) {
    most = robot.links[i].deviation > most ? robot.links[i].deviation : most;
  }
  return most;
}

/// A sum of motions; saturates at 64 bits, which is more than any distance.
class Travel {
 public:
  /// `by`: units of the joint's coordinate.
  void add(uint32_t reach, uint32_t by) {
    const uint64_t way = static_cast<uint64_t>(reach) * by;
    sum_ = way > kMost - sum_ ? kMost : sum_ + way;
  }
  /// add() without saturation, if the sum of all reaches fits 32 bits and no `by` is above 2^31.
  void add_short(uint32_t reach, uint32_t by) { sum_ += static_cast<uint64_t>(reach) * by; }
  /// The sum in 1/256 cell, rounded up.
  uint32_t fine() const {
    const uint64_t whole = (sum_ + kBelowOne) >> kReachBits;
    return whole > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(whole);
  }

 private:
  static constexpr uint64_t kBelowOne = (uint64_t{1} << kReachBits) - 1;
  static constexpr uint64_t kMost = UINT64_MAX - kBelowOne;

  uint64_t sum_ = 0;
};

}  // namespace flashbvh::detail
