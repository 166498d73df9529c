// Lets a host move an arm's servos as far as no two links get too near each other.
//
// A forwarder between a host and a servo bus, by itself: bytes in and out, and the time as an
// argument. No UARTs, no heap, no floats. A board calls from_host() and from_bus() for each byte,
// tick() in its loop, and sends what is in to_bus, to_host and text.
//
// Goals are what Guard::limit() grants, a step of at most the servos' speed a period. limit()
// proves each step from the goals of the last one, so servos have to be there: a step is sent if
// all servos are within kNear of the last goals, or if the guard proves the box of all values
// between the last readings and all goals since, which servos that move evenly don't leave.
//
// While any position is unknown, stale, or of a servo without torque, no goal passes: the servos
// keep theirs. When all servos stand still the guard starts again from where they are, and makes
// that their goals. So it also does for servos that stand still farther than kMoved from their
// goals.
#pragma once

#include <flashbvh/robot/guard.hpp>

#include "packet.hpp"

namespace servo {

constexpr uint32_t kPeriod = 5'000;  ///< in microseconds, as all times
constexpr int32_t kCounts = 4096;    ///< of a turn
constexpr flashbvh::JointCoordinate kCount = (1 << 28) / kCounts;  ///< a count's coordinate
constexpr int32_t kNear = 1;       ///< counts from its goal, at most, of a servo that arrived
constexpr int32_t kSlack = 3;      ///< counts beyond a joint's limits that are taken for the limit
constexpr int32_t kMoved = 64;     ///< counts from its goal, at least, of a servo that won't
constexpr uint8_t kStill = 10;     ///< readings of a servo that stands still
constexpr uint8_t kStalled = 100;  ///< readings of a servo that gave up its goal
constexpr uint32_t kWork = 500;    ///< of each call to the guard, in units of query.hpp
constexpr uint32_t kMaxServos = 16;

/// A line of an arm's file.
struct Servo {
  uint8_t variable;  ///< of the robot
  uint8_t id;
  int32_t offset;  ///< the count at the joint's zero
  int32_t sign;    ///< 1, or -1: counts grow as the joint's value falls
  int32_t speed;   ///< counts a second, at most
};

/// A board's times.
struct Times {
  uint32_t silence = 5'000;  ///< after so long a servo does not answer, and a packet has ended
  uint32_t stale = 100'000;  ///< the age at which a position is unknown
};

/// Bytes in order; an interrupt's handler may put them. Those that don't fit are lost.
template <uint32_t size>
class Queue {
 public:
  uint32_t room() const { return size - 1 - (end_ + size - first_) % size; }
  bool is_empty() const { return first_ == end_; }
  void put(uint8_t byte) {
    if (room() != 0) {
      bytes_[end_] = byte;
      end_ = (end_ + 1) % size;
    }
  }
  uint8_t take() {
    const uint8_t byte = bytes_[first_];
    first_ = (first_ + 1) % size;
    return byte;
  }

 private:
  volatile uint8_t bytes_[size] = {};
  volatile uint32_t first_ = 0;
  volatile uint32_t end_ = 0;
};

enum class State : uint8_t {
  silent,   ///< a servo's position is not known
  loose,    ///< a servo has no torque
  moving,   ///< a servo moves, so the guard can't start
  refused,  ///< the guard refuses the positions: a joint is beyond its limits
  free,     ///< goals pass
  held,     ///< goals are shortened
  lagging,  ///< goals wait for a servo
};

class ServoGuard {
 public:
  Queue<1024> to_host;
  Queue<1024> to_bus;
  Queue<256> text;  ///< a line a second

  /// `image`: the robot's, for names. `servos`: one for each of the robot's variables, at most
  /// kMaxServos.
  ServoGuard(const flashbvh::Robot& robot, const void* image, flashbvh::Guard& guard,
             const Servo* servos, const Times& times);

  /// Whether from_host() takes a byte: not while a packet waits for an answer of the bus.
  bool takes_host() const { return !host_.has_packet(); }
  void from_host(uint8_t byte);
  void from_bus(uint8_t byte);
  /// `now`: microseconds, modulo 2^32.
  void tick(uint32_t now);

  State state() const { return state_; }
  /// On while goals pass; blinks fast while they are held, slowly while none passes.
  bool led() const;

 private:
  /// A servo, in counts.
  struct Joint {
    int32_t lowest;  ///< limits
    int32_t highest;
    int32_t measured;
    int32_t anchor;  ///< measured when it moved last
    int32_t wanted;
    int32_t sent;  ///< the goal
    int32_t next;  ///< the next goal, granted
    int32_t low;   ///< where it may be
    int32_t high;
    uint32_t measured_at;
    uint8_t still;  ///< readings near the anchor
    bool is_known;
    bool is_loose;
  };

  uint32_t find(uint8_t id) const;
  bool is_fresh(const Joint& joint) const;
  flashbvh::JointCoordinate coordinate(uint32_t i, int32_t count) const;
  bool has_time_on_bus() const;
  void serve();
  void handle(const Packet& packet);
  void withhold(const Packet& packet);
  void forward(const uint8_t* bytes, uint32_t size);
  void request(const Packet& packet);
  void send_goals(uint32_t servos);
  bool knows_all(const Packet& packet, const Writes& writes) const;
  void take_goals(const Packet& packet, const Writes& writes);
  void enable(const Packet& packet, const Writes& writes);
  void poll();
  void answer(const Packet& packet);
  void measure(Joint& joint, int32_t count);
  void period();
  void stop(State state, uint32_t i);
  void start();
  bool is_near() const;
  bool is_box_free();
  void step();
  void say();
  void put(const char* words);
  void put(uint32_t number);

  const flashbvh::Robot* robot_;
  const void* image_;
  flashbvh::Guard* guard_;
  const Servo* servos_;
  Times times_;
  uint32_t count_;
  Joint joints_[kMaxServos + 1] = {};  ///< the last one: any other servo
  Parser host_;
  Parser bus_;
  State state_ = State::silent;
  uint8_t about_ = 0;  ///< the servo's id that `state_` is about
  bool is_guarding_ = false;
  bool has_stepped_ = false;  ///< in this period
  bool is_pending_ = false;   ///< `next` is granted and not sent
  bool owes_ = false;         ///< `sent` is not on the bus yet
  bool is_own_ = false;       ///< the last request was this guard's
  bool is_old_ = false;       ///< goals were sent since the last request
  uint8_t asked_ = 0;         ///< of the last request: id,
  uint8_t first_ = 0;         ///< register,
  uint8_t bytes_ = 0;         ///< and number of them; 0: no reading
  uint32_t awaited_ = 0;      ///< bytes of answers
  uint32_t next_poll_ = 0;
  uint32_t polls_ = 0;  ///< left in this period
  uint32_t now_ = 0;
  uint32_t period_at_ = 0;
  uint32_t said_at_ = 0;
  uint32_t heard_at_ = 0;  ///< the host
  uint32_t bus_at_ = 0;    ///< the last byte to the bus or from it
  uint32_t own_at_ = 0;    ///< the last packet of one's own
  uint32_t periods_ = 0;
  uint32_t goals_ = 0;
  uint32_t shortened_ = 0;
  uint32_t withheld_ = 0;
  uint32_t silences_ = 0;
  uint8_t last_withheld_[2] = {};  ///< instruction and register
  uint16_t pair_ = flashbvh::kNoPair;
};

}  // namespace servo
