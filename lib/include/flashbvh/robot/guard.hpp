// The guard takes a robot's joint values each period. It reports if any two of its links are too
// near to each other, or may have been during the period.
//
// Guarantee. A period runs from the last values to the current ones. If the verdict is `free` or
// `warn`, every pair of links that can collide stayed farther apart than its stop distance at every
// moment of the period. This holds under exact kinematics, if each joint moved monotonically
// between the two values, at any speed, and each joint without limits by less than half a turn. The
// links are those of the URDF, unrounded: Robot::slack covers the errors of rounding vertices to
// the lattice and of arithmetic. The user adds braking distance, encoder error and flex to the stop
// distance. Verdicts do not latch and have no hysteresis.
//
// Method (lib/docs/design.md, "Robots"). A certificate of a pair is a distance and the coordinates
// at which it was measured. The pair is free while the joints between its links move them nearer by
// at most the certificate's excess over the stop distance. The guard measures expiring certificates
// again in slices of work, the first to expire first. If the budget is too small, the verdict is
// `not_yet_known`, never `free`; the caller treats it as `stop`.
//
// A pair that has been inside its stop distance since the start has a floor instead, the largest
// distance that update() measured. While it gets no nearer than that less a tenth of the stop
// distance, the verdict is `leaving`, which permits only what limit() grants. Floors never fall:
// prime() forgets them.
//
// The guard tests surfaces: a link inside another one is as far from it as from its wall.
//
// Stack on Cortex-M3 to M55 at -O2: update() 1,136 bytes, limit() 1,352.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh {

/// Verdicts, from the best to the worst.
enum class Verdict : uint8_t {
  free = FLASHBVH_VERDICT_FREE,
  warn = FLASHBVH_VERDICT_WARN,
  leaving = FLASHBVH_VERDICT_LEAVING,
  not_yet_known = FLASHBVH_VERDICT_NOT_YET_KNOWN,
  stop = FLASHBVH_VERDICT_STOP,
  refused = FLASHBVH_VERDICT_REFUSED,
};

/// No pair: all pairs are free.
constexpr uint16_t kNoPair = 0xFFFF;

using GuardAnswer = flashbvh_guard_answer;

/// Verdicts of Guard::limit().
enum class LimitVerdict : uint8_t {
  granted = FLASHBVH_LIMIT_GRANTED,
  shortened = FLASHBVH_LIMIT_SHORTENED,
  held = FLASHBVH_LIMIT_HELD,
  not_yet_known = FLASHBVH_LIMIT_NOT_YET_KNOWN,
  refused = FLASHBVH_LIMIT_REFUSED,
};

using LimitAnswer = flashbvh_limit_answer;

constexpr uint32_t kNoFloor = (1u << 31) - 1;  ///< of a pair that limit() has not measured
constexpr uint32_t kNotMeasured = UINT32_MAX;  ///< in place of GuardPair::granted
/// update() measured the certificate, so the robot has been where it was measured.
constexpr uint32_t kOwn = 1u << 31;
/// limit() measured the certificate, so `began` is of the next period.
constexpr uint32_t kOfNext = 1u << 31;
/// With a floor's other bits the motion that a released pair may make in a command.
constexpr uint32_t kReleased = 1u << 31;

/// A pair's certificate. 28 bytes, and 5 for each joint between its links.
struct GuardPair {
  uint32_t lower;             ///< the measured distance, in 1/256 cell, rounded down; 0: unknown
  uint32_t upper;             ///< rounded up; UINT32_MAX: unknown
  uint32_t began;             ///< lower bound at the period's start
  Witness<uint16_t> witness;  ///< the nearest triangles
  uint32_t seen;     ///< the largest distance before `lower`; with kOwn `lower` counts, too
  uint32_t floor;    ///< Guard::limit(): the largest distance so far, or its cap
  uint32_t granted;  ///< lower bound at the granted values; of a released pair Guard::release()
};

/// A guard's state in addition to its arrays.
struct GuardCore {
  uint32_t version : 8;
  uint32_t laps : 24;  ///< sum of RobotJoint::laps of all obstacles in the last period, modulo 2^24
  uint32_t robot_hash;
  uint32_t checksum;     ///< of the rest of the state, by Guard::seal()
  uint16_t walked_pair;  ///< the pair that is being measured, or kNoPair
  uint8_t has_values;    ///< 0 or not; no bool, since a damaged state may hold any value
  uint8_t has_frames;
  uint32_t asked;     ///< distance tested in the measurement, in 1/256 cell
  uint32_t nearest;   ///< distance of `witness`, rounded up
  uint32_t kept;      ///< distance that limit() wants to know of; 0: update() measures
  uint32_t rounding;  ///< the slack without the links' deviation, in 1/256 cell
  uint32_t roaming;   ///< way of any joint from the granted values within which all pairs are free
  uint16_t share;     ///< of the way to GuardStateOf::tried, in 1/4,096; 0: none
  uint16_t shortened_by;  ///< the pair that allows no more than this share, or kNoPair
  Witness<uint16_t> witness;
  QueryCursor<uint16_t> cursor;
  Pose pose = Pose::translated(0, 0, 0);
};

/// In place of a variable's number: no variable.
constexpr uint8_t kNoVariable = 0xFF;

/// The nearest points of two links, and the direction that separates them.
struct [[nodiscard]] PairDetail {
  /// `done`; `guard_state_invalid`: there was no period yet, or no such pair; or a query's error.
  Status status;
  /// Nearest points of the two triangles that the last measurement found nearest, at the end of the
  /// period, in the base's frame. The links may be nearer elsewhere: distance(), with `witness` as
  /// its hint, measures that.
  NearestPoints nearest;
  TrianglePair<uint16_t> triangles;  ///< by their ids
  Witness<uint16_t> witness;
  /// The variable that brought these points nearer by most in this period. If none did, the one
  /// with the largest magnitude in `changes`; or kNoVariable.
  uint8_t variable;
};

namespace detail {
constexpr uint32_t at_least_one(uint32_t count) {
  return count != 0 ? count : 1;
}
}  // namespace detail

/// All memory of a guard: plain data without pointers. It may be copied, stored and resumed
/// (Guard::resume()). A robot's header has the counts.
template <uint32_t joint_count, uint32_t pair_count, uint32_t pair_joint_count>
struct GuardStateOf {
  static constexpr uint32_t kJoints = detail::at_least_one(joint_count);

  GuardCore core;
  JointCoordinate before[kJoints];   ///< coordinates at the start of the period
  JointCoordinate step[kJoints];     ///< change of the coordinates in the period
  JointCoordinate next[kJoints];     ///< new coordinates until they are accepted; also for frames
  JointCoordinate walked[kJoints];   ///< coordinates at the start of the measurement
  JointCoordinate granted[kJoints];  ///< coordinates that limit() granted last
  JointCoordinate tried[kJoints];    ///< coordinates that limit() had too little work for since
  Frame frames[kJoints];
  GuardPair pairs[detail::at_least_one(pair_count)];
  JointCoordinate certified[detail::at_least_one(
      pair_joint_count)];  ///< of all joints between, pair after pair
  /// Lever arms at the certificate, as (share + 1) / 256 of the joints' reaches (levers.hpp).
  uint8_t shares[detail::at_least_one(pair_joint_count)];
  uint8_t walked_shares[kJoints];  ///< for the pair that is being measured
};

/// The guard of one robot. All its certificates are in the state.
class Guard {
 public:
  /// Starts without certificates. `robot` and `state` must outlive it; the state is written.
  template <uint32_t joint_count, uint32_t pair_count, uint32_t pair_joint_count>
  Guard(const Robot& robot, GuardStateOf<joint_count, pair_count, pair_joint_count>& state)
      : robot_(&robot),
        core_(&state.core),
        before_(state.before),
        step_(state.step),
        next_(state.next),
        walked_(state.walked),
        granted_(state.granted),
        tried_(state.tried),
        frames_(state.frames),
        pairs_(state.pairs),
        certified_(state.certified),
        shares_(state.shares),
        walked_shares_(state.walked_shares) {
    fit_ =
        detail::fit_of(robot, joint_count >= robot.joint_count && pair_count >= robot.pair_count &&
                                  pair_joint_count >= joints_between());
    forget();
  }

  /// Takes `size` bytes instead, with the layout of a GuardStateOf of the robot's own counts.
  Guard(const Robot& robot, void* memory, size_t size)
      : robot_(&robot),
        core_(static_cast<GuardCore*>(memory)),
        before_(reinterpret_cast<JointCoordinate*>(core_ + 1)),
        step_(before_ + robot.joint_count),
        next_(step_ + robot.joint_count),
        walked_(next_ + robot.joint_count),
        granted_(walked_ + robot.joint_count),
        tried_(granted_ + robot.joint_count),
        frames_(reinterpret_cast<Frame*>(tried_ + robot.joint_count)),
        pairs_(reinterpret_cast<GuardPair*>(frames_ + robot.joint_count)),
        certified_(reinterpret_cast<JointCoordinate*>(pairs_ + robot.pair_count)),
        shares_(reinterpret_cast<uint8_t*>(certified_ + joints_between())),
        walked_shares_(shares_ + joints_between()) {
    const auto begin = reinterpret_cast<uintptr_t>(memory);
    const auto end = reinterpret_cast<uintptr_t>(walked_shares_ + robot.joint_count);
    fit_ =
        detail::fit_of(robot, begin % alignof(GuardCore) == 0 && (end - begin + 3) / 4 * 4 <= size);
    forget();
  }

  /// True if the robot is open and the memory is large enough for it.
  bool fits() const { return fit_ == detail::Fit::fits; }
  /// Returns `done`; `not_open`: the robot is not, and each period is refused; or
  /// `guard_state_invalid`: the memory is too small.
  Status status() const { return detail::status_of(fit_, robot_); }

  /// Discards all certificates and the last values.
  void forget();

  /// Resumes with a stored state that was copied back into its place. `guard_state_invalid`, and
  /// the guard forgets all, if it is not one of this robot's, or has no values yet: its period
  /// would cover no motion. `not_open`, as from all functions. Certificates with obstacles are
  /// discarded, since their workcell may be a new one: place obstacles before. The next period
  /// begins with obstacles where they stand now, and covers no earlier motion of them.
  Status resume();

  /// Stores checksums of the guard, of the robot's view, of its meshes' views and of the whole
  /// state for verify(). Call it after each update(), go_on(), limit() and release(), and after the
  /// robot's view or a mesh's changes.
  void seal();

  /// `done`: nothing changed since seal(). `not_open`: the robot was not, so nothing was sealed.
  /// `guard_state_invalid`: memory is damaged, or was not sealed; do not use guard or robot.
  /// Detects every change within one aligned 32-bit word, and others except with probability 2^-32.
  /// Follows no pointer before its checksum holds. The state's checksum has no addresses: if a
  /// stored, sealed state is copied into the place of a sealed guard's state, verify() checks that
  /// copy.
  ///
  /// Does not read the views' arrays: RegionTest (memory_region.hpp) checks images in flash and
  /// a workcell's memory. On a Cortex-M4F at -O2 both take about 4 instructions a word, 1,500 for a
  /// KUKA KR5 of 6 joints; 96 bytes of stack.
  Status verify() const;

  /// Runs a period from the last values to these. `values`: variable_count values. `work`: the
  /// budget for measuring, as in queries (query.hpp), overdrawn by one step at most. The test of
  /// all certificates is extra.
  GuardAnswer update(const JointCoordinate* values, uint32_t work);

  /// Continues the current period with more work.
  GuardAnswer go_on(uint32_t work);

  /// Lets a command through as far as no pair comes nearer than it may: the way out for an arm that
  /// is inside its stop distance, and the way in for none.
  ///
  /// The motion leads from the last granted values, the first ones after prime(), to `wanted`. Sets
  /// `granted`, variable_count values in another array: a share of the way of all joints. A pair's
  /// floor is the largest distance that was measured so far, at most its stop distance and a tenth.
  /// At each moment of the granted motion, each joint monotone, no pair is nearer than its floor
  /// less a tenth of the stop distance, or half the floor if that is nearer. So pairs outside, as
  /// measured, keep their stop distance, and pairs inside get no deeper than a tenth of it, ever.
  /// Distances are those of the URDF's links, but inside the stop distance those of the baked
  /// links.
  ///
  /// Too little `work` shortens the motion; called again with the same values, it goes on. The
  /// first call measures the pairs near their stop distance where the robot is, and grants nothing
  /// until they are known. A floor falls only if an obstacle comes nearer than it allows.
  LimitAnswer limit(const JointCoordinate* wanted, JointCoordinate* granted, uint32_t work);

  /// Lets a pair that intersects, or that is as far apart as it gets nearby, move without regard to
  /// its distance, by at most `a_command` in each, until it is a tenth of its stop distance farther
  /// apart than now: then it has a floor again. Nothing keeps it from getting deeper: the caller
  /// has to know the way. update() takes it for `leaving`. Call it after a limit() that was held.
  /// `done`; `guard_state_invalid`: no such pair, or no period yet; `distance_out_of_range`: over
  /// kMaxGuardDistance.
  Status release(uint16_t pair, FineLength a_command);

  /// The floor of a pair below pair_count, as measured, in 1/256 cell; 0 before limit() measured
  /// it, and while it is released.
  uint32_t floor(uint16_t pair) const {
    const uint32_t floor = pairs_[pair].floor;
    return is_released(floor) || floor == kNoFloor ? 0 : floor;
  }

  /// Explains a pair's distance at the end of the period. `changes`: variable_count derivatives of
  /// the distance by each variable, in 2^-kReachBits of 1/256 cell, as reaches are; positive if the
  /// distance grows with the joint. All are 0 if the triangles intersect. Changes no state. Linked
  /// only if called.
  PairDetail explain(uint16_t pair, int32_t* changes);

  /// Measures all certificates without a budget, at start-up before the first period. The robot
  /// stands still.
  GuardAnswer prime(const JointCoordinate* values) {
    forget();
    return update(values, UINT32_MAX);
  }

 private:
  struct Found;
  struct Left;
  struct Give;
  struct Measured;
  struct Share;
  struct Bounds;
  struct Keep;
  struct Try;

  uint32_t joints_between() const;
  bool is_possible() const;
  bool has_values() const;
  Status refusal() const;
  bool is_obstacle(uint8_t link) const;
  bool has_obstacle(uint16_t pair) const;
  void follow_obstacle(uint32_t joint);
  void forget_obstacles();
  bool has_triangles(uint16_t pair, const Witness<uint16_t>& witness) const;
  Status move_to(const JointCoordinate* values);
  Status measure(const Found& found, uint32_t& work);
  template <class Visit>
  bool for_each_way(const RobotPair& pair, uint32_t first, Visit&& visit) const;
  uint32_t motion_of(const RobotPair& pair, uint32_t first, bool& is_fresh) const;
  uint32_t motion_by_levers(const RobotPair& pair, uint32_t first) const;
  Left left_of(uint16_t pair, uint32_t first, bool by_levers) const;
  uint32_t rounding() const;
  Give give_of(uint16_t pair) const;
  uint32_t lowest_of(uint16_t pair, bool is_current) const;
  uint32_t distance_where_begun(uint16_t pair, uint32_t of_next) const;
  uint32_t moved_in_walk() const;
  uint32_t rate_of(const RobotPair& pair) const;
  uint32_t longest_step() const;
  FLASHBVH_NOINLINE void look_inside(uint16_t pair, uint32_t most, Left& now) const;
  FLASHBVH_NOINLINE Verdict verdict_of(uint16_t pair, const Left& now) const;
  Found look();
  uint32_t first_between(uint16_t pair) const;
  void start_walk(uint16_t pair, uint32_t& work);
  void begin_walk(uint16_t pair, uint32_t& work);
  bool is_free_after(const RobotPair& pair, uint32_t distance, uint32_t rate) const;
  bool certify_by_spheres(uint16_t pair, uint32_t rate);
  bool certify_by_table(uint16_t pair, uint32_t rate);
  FLASHBVH_NOINLINE uint32_t witness_distance(uint32_t& work) const;
  uint32_t limit_for(uint16_t pair, uint32_t nearest) const;
  void aim(uint32_t nearest);
  void aim_to_know(uint32_t nearest);
  Status walk(uint32_t& work);
  Status finish(uint32_t lower);
  void certify(uint16_t pair, const JointCoordinate* at, const Measured& measured, bool is_own,
               const uint8_t* shares);
  Pose pose_of(const RobotPair& pair) const;
  bool is_free(uint32_t joint) const;
  int32_t step_to_next(uint32_t joint) const;
  template <class StepOf>
  bool has_one_way(uint32_t joint, StepOf&& step_of) const;
  void set_next();
  void make_frames();
  Share share_of(const RobotPair& pair, uint8_t variable, const NearestPoints& nearest) const;
  bool place_witness(uint16_t pair, const Witness<uint16_t>& witness, const Pose& pose, Triangle& a,
                     Triangle& b) const;
  static bool is_released(uint32_t floor) { return floor >= kReleased; }
  Keep keep_of(uint16_t pair) const;
  Status begin_command(const JointCoordinate* wanted);
  void set_share(const JointCoordinate* wanted, uint32_t share, JointCoordinate* granted);
  int32_t step_from(int32_t from, uint32_t joint) const;
  uint32_t longest_way() const;
  uint32_t find_share(const JointCoordinate* wanted, JointCoordinate* granted, uint32_t& work,
                      LimitAnswer& answer);
  uint32_t room_of(uint16_t pair, uint32_t first, uint32_t cap) const;
  Bounds bounds_of(uint16_t pair, uint32_t first) const;
  void know(uint16_t pair, uint32_t distance);
  bool knows_floors() const;
  Status know_floors(uint32_t& work);
  Status measure_at_next(uint16_t pair, uint32_t needed, bool is_for_floor, uint32_t& work);
  Status walk_on(uint32_t needed, uint32_t& work);
  void measure_released(uint32_t& work);
  bool is_walking() const;
  bool is_walked_at_next(uint16_t pair) const;
  bool is_tried() const;
  uint32_t first_share(const JointCoordinate* wanted, JointCoordinate* granted,
                       LimitAnswer& answer);
  Try try_known(uint16_t pair, uint32_t first, const Keep& keep, uint32_t& needed) const;
  Try try_pair(uint16_t pair, uint32_t& work);
  Try try_all_known();
  Try try_all(uint32_t& work);
  void accept();
  uint32_t own_checksum() const;
  uint32_t robot_checksum() const;
  uint32_t meshes_checksum() const;
  uint32_t state_checksum() const;

  const Robot* robot_;
  GuardCore* core_;
  JointCoordinate* before_;
  JointCoordinate* step_;
  JointCoordinate* next_;
  JointCoordinate* walked_;
  JointCoordinate* granted_;
  JointCoordinate* tried_;
  Frame* frames_;
  GuardPair* pairs_;
  JointCoordinate* certified_;
  uint8_t* shares_;
  uint8_t* walked_shares_;
  detail::Fit fit_;
  uint32_t robot_seal_ = 0;
  uint32_t meshes_seal_ = 0;
  uint32_t seal_ = 0;  ///< checksum of all words before it
};

}  // namespace flashbvh

#pragma GCC diagnostic pop
