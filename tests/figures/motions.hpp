// Motions of an arm for figures: cubic ones between random places, on which no links intersect. In
// integers, so that every core and the host see the same.
#ifndef FLASHBVH_TESTS_FIGURES_MOTIONS_HPP
#define FLASHBVH_TESTS_FIGURES_MOTIONS_HPP

#include <stdint.h>

#include "flashbvh/robot/motion.hpp"
#include "support/random.hpp"

namespace figures {

/// Units of a joint's coordinate in a period at top speed.
template <uint32_t joints>
using TopSpeeds = int32_t[joints];

template <class MotionState, uint32_t joints>
class Motions {
 public:
  /// `percent`: of the top speed of the joint that takes longest; the others take as long.
  Motions(const flashbvh::Robot& robot, MotionState& memory, const TopSpeeds<joints>& top,
          uint32_t percent, uint64_t seed)
      : robot_(robot), query_(robot, memory), top_(top), percent_(percent), random_(seed) {}

  /// Where the arm begins, at 0.
  const flashbvh::JointCoordinate* values() const { return values_; }

  /// A period on.
  void next() {
    if (at_ == periods_) {
      begin();
    }
    ++at_;
    // 3x^2 - 2x^3, x with 15 fraction bits.
    const int64_t x = (int64_t{at_} << 15) / periods_;
    const int64_t share = (x * x >> 15) * (3 * 32768 - 2 * x);
    for (uint32_t i = 0; i < joints; ++i) {
      const int64_t way = static_cast<int64_t>(to_[i]) - from_[i];
      values_[i] = static_cast<int32_t>(from_[i] + (way * share >> 30));
    }
  }

 private:
  void begin() {
    do {
      periods_ = 1;
      at_ = 0;
      for (uint32_t i = 0; i < joints; ++i) {
        const flashbvh::RobotJoint& joint = robot_.joints[i];
        from_[i] = values_[i];
        to_[i] = random_.between(joint.lower, joint.upper);
        // A cubic's top speed is 3/2 of its mean one.
        const int64_t way = static_cast<int64_t>(to_[i]) - from_[i];
        const auto periods =
            static_cast<uint32_t>((way < 0 ? -way : way) * 150 / (int64_t{top_[i]} * percent_)) + 1;
        periods_ = periods > periods_ ? periods : periods_;
      }
    } while (query_.start(from_, to_) != flashbvh::Status::done ||
             query_.run(UINT32_MAX).outcome != flashbvh::MotionOutcome::free);
  }

  const flashbvh::Robot& robot_;
  flashbvh::MotionQuery query_;
  const TopSpeeds<joints>& top_;
  uint32_t percent_;
  flashbvh::test::Random random_;
  flashbvh::JointCoordinate from_[joints] = {};
  flashbvh::JointCoordinate to_[joints] = {};
  flashbvh::JointCoordinate values_[joints] = {};
  uint32_t periods_ = 0;
  uint32_t at_ = 0;
};

}  // namespace figures

#endif
