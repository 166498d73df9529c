// Construction of body motions, and the body's pose at a time.
#include "flashbvh/first_contact.hpp"

#include "../lattice/sine.hpp"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "moved_frame.hpp"

namespace flashbvh {
namespace {

using detail::square_root;

constexpr uint64_t square_of(int32_t value) {
  return static_cast<uint64_t>(int64_t{value} * value);
}

/// Turns below it count as none, since 30 fraction bits hardly show them: 2^-22 radians.
constexpr uint32_t kNoTurn = 1 << 7;

/// Twice the angle whose sine and cosine these are, up to a common factor. At most half a turn.
/// Found by bisection.
int32_t twice_angle(uint32_t sine, uint32_t cosine) {
  uint32_t angle = 0;  // in 2^-32 turn
  for (uint32_t bit = 1u << 30; bit != 1; bit >>= 1) {
    const detail::SineCosine at = detail::sine_cosine(angle + bit);
    const bool is_beyond = int64_t{at.sine} * cosine > int64_t{at.cosine} * sine;
    angle += is_beyond ? 0 : bit;
  }
  return static_cast<int32_t>(angle >> 3);
}

/// Sets the axis and angle of the rotation from one pose to another.
void set_turn(const Pose& from, const Pose& to, Move& move) {
  int32_t r[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      int64_t sum = 0;
      for (int k = 0; k < 3; ++k) {
        sum += int64_t{to.rotation(i, k)} * from.rotation(j, k);
      }
      r[i][j] = static_cast<int32_t>((sum + (kRotationOne >> 1)) >> 30);
    }
  }
  // The rotation's quaternion from its largest component i: 4 q_i q_j for each j.
  const int64_t trace = int64_t{r[0][0]} + r[1][1] + r[2][2];
  int largest = 3;
  int64_t most = trace;
  for (int i = 0; i < 3; ++i) {
    if (r[i][i] > most) {
      most = r[i][i];
      largest = i;
    }
  }
  int64_t q[4];
  if (largest == 3) {
    q[3] = trace + kRotationOne;
    q[0] = int64_t{r[2][1]} - r[1][2];
    q[1] = int64_t{r[0][2]} - r[2][0];
    q[2] = int64_t{r[1][0]} - r[0][1];
  } else {
    const int i = largest;
    const int j = i == 2 ? 0 : i + 1;
    const int k = 3 - i - j;
    q[i] = int64_t{kRotationOne} + r[i][i] - r[j][j] - r[k][k];
    q[j] = int64_t{r[i][j]} + r[j][i];
    q[k] = int64_t{r[i][k]} + r[k][i];
    q[3] = int64_t{r[k][j]} - r[j][k];
  }
  const int64_t sign = q[3] < 0 ? -1 : 1;
  int32_t v[3];
  uint64_t squared = 0;
  for (int i = 0; i < 3; ++i) {
    v[i] = static_cast<int32_t>(sign * q[i] >> 2);  // hardly above 2^30
    squared += square_of(v[i]);
  }
  const uint32_t sine = square_root(squared);
  const auto cosine = static_cast<uint32_t>(sign * q[3] >> 2);
  if (sine < kNoTurn) {
    return;
  }
  move.turn = twice_angle(sine, cosine);
  for (int i = 0; i < 3; ++i) {
    move.axis[i] = static_cast<int32_t>(int64_t{v[i]} * kRotationOne / sine);
  }
}

bool is_in_reach(const Pose& pose) {
  constexpr int32_t most = kMaxFrameTranslation >> kFrameBits;
  for (int i = 0; i < 3; ++i) {
    if (pose.translation(i) >= most || pose.translation(i) <= -most) {
      return false;
    }
  }
  return true;
}

bool is_unit(const int32_t (&axis)[3]) {
  const uint64_t squared = square_of(axis[0]) + square_of(axis[1]) + square_of(axis[2]);
  const auto one = square_of(kRotationOne);
  const uint64_t off = squared < one ? one - squared : squared - one;
  return off >> 30 <= static_cast<uint64_t>(kAxisTolerance);
}

}  // namespace

uint64_t detail::farthest(const BodyMotion& motion, uint64_t farthest) {
  for (uint32_t i = motion.move_count(); i-- > 0;) {
    const Move& move = motion.move(i);
    const uint64_t point = move.turn == 0 ? 0 : length_of(move.point);
    farthest += 2 * point + length_of(move.travel);
  }
  return farthest;
}

BodyMotion::BodyMotion(const Pose& from, const Pose& to)
    : from_(from),
      to_(to),
      moves_(nullptr),
      own_(),
      count_(1),
      status_(from.status() != Status::done ? from.status() : to.status()) {
  if (status_ == Status::done && !(is_in_reach(from) && is_in_reach(to))) {
    status_ = Status::motion_out_of_range;
  }
}

void BodyMotion::check() {
  for (uint32_t i = 0; i < count_ && status_ == Status::done; ++i) {
    if (move(i).turn != 0 && !is_unit(move(i).axis)) {
      status_ = Status::not_a_rotation;
    }
  }
  if (status_ == Status::done &&
      detail::farthest(*this, detail::length_of(detail::frame_of(from_).translation)) >
          kMaxFrameTranslation) {
    status_ = Status::motion_out_of_range;
  }
}

BodyMotion BodyMotion::between(const Pose& from, const Pose& to) {
  BodyMotion motion(from, to);
  if (motion.status_ != Status::done) {
    return motion;
  }
  const Frame begin = detail::frame_of(from);
  const Frame end = detail::frame_of(to);
  for (int i = 0; i < 3; ++i) {
    motion.own_.point[i] = begin.translation[i];
    motion.own_.travel[i] = end.translation[i] - begin.translation[i];
  }
  if (!(from.is_translation() && to.is_translation())) {
    set_turn(from, to, motion.own_);
  }
  motion.check();
  return motion;
}

BodyMotion::BodyMotion(const Pose& from, const Move* moves, uint32_t count)
    : BodyMotion(from, from) {
  moves_ = moves;
  count_ = count;
  if (status_ != Status::done) {
    return;
  }
  check();
  if (status_ == Status::done) {
    to_ = detail::pose_of(detail::frame_at(*this, kMotionEnd));
    status_ = to_.status();
  }
}

Frame detail::frame_at(const BodyMotion& motion, uint32_t time) {
  Frame frame = frame_of(motion.from());
  for (uint32_t i = motion.move_count(); i-- > 0;) {
    carry(motion.move(i), time, frame);
  }
  return frame;
}

Pose BodyMotion::pose_at(uint32_t time) const {
  if (status() != Status::done) {
    return Pose::translated(INT32_MAX, 0, 0);
  }
  return time == 0            ? from_
         : time >= kMotionEnd ? to_
                              : detail::pose_of(detail::frame_at(*this, time));
}

}  // namespace flashbvh
