// The guard takes a robot's joint values each period and reports whether any two of its links are,
// or may have been on the way, too near to each other.
//
// What is promised. A period runs from the last values to these. If the verdict is `free` or
// `warn`, every pair of links that can collide stayed farther apart than its stop distance at every
// moment of the period, under exact kinematics, as long as each joint moved monotonically between
// the two values, however unevenly. The links are those of the URDF, unrounded: Robot::slack, what
// rounding vertices to the lattice and arithmetic can be wrong by, is in it. What is the user's:
// braking distance, encoder error and flex go into the stop distance; the verdicts don't latch and
// have no hysteresis.
//
// How. A certificate of a pair is a distance, and the coordinates at which it was measured. As long
// as the joints between the two links have not moved them nearer by more than what the distance has
// over the stop distance (a joint moves a point by at most its reach times its angle), the pair is
// free and nothing is looked at; not even a pose is made. Certificates that are about to run out
// are measured again, those that run out first before the others, in slices of work: a budget too
// small shows as `not_yet_known`, which a caller treats as `stop`. It never shows as `free`. The
// sum over joints is that of Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision Checking"
// (2005), with the farther of the two values of each joint, and what joints move the links where
// they stood. Where a period begins and ends, two distances are known: between them a pair loses
// half of the period's motion at most (lib/docs/derivations.md, "Levers", "Both ends of a period").
//
// Surfaces are guarded: a link wholly inside another one is as far from it as from its wall.
//
// Stack of update() on Cortex-M3 to M55 at -O2: 1,136 bytes.
#ifndef FLASHBVH_ROBOT_GUARD_HPP
#define FLASHBVH_ROBOT_GUARD_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// From the best to the worst.
enum class Verdict : uint8_t {
  free = FLASHBVH_VERDICT_FREE,
  warn = FLASHBVH_VERDICT_WARN,
  not_yet_known = FLASHBVH_VERDICT_NOT_YET_KNOWN,
  stop = FLASHBVH_VERDICT_STOP,
  refused = FLASHBVH_VERDICT_REFUSED,
};

/// No pair: every one is free.
constexpr uint16_t kNoPair = 0xFFFF;

using GuardAnswer = flashbvh_guard_answer;

/// What is known of a pair. 16 bytes, and 5 for each joint between its links.
struct GuardPair {
  uint32_t lower;             ///< the distance then, in 1/256 cell, rounded down; 0: not known
  uint32_t upper;             ///< rounded up; UINT32_MAX: not known
  uint32_t began;             ///< where the period began they were so far apart or farther
  Witness<uint16_t> witness;  ///< where they were nearest
};

/// The state of a guard in addition to its arrays.
struct GuardCore {
  uint32_t version;
  uint32_t robot_hash;
  uint32_t checksum;     ///< of the rest of the state, by Guard::seal()
  uint16_t walked_pair;  ///< that is being measured, or kNoPair
  uint8_t has_values;    ///< 0 or not: of a state that was damaged, no bool
  uint8_t has_frames;
  uint32_t asked;    ///< of the pair: whether it is within this, in 1/256 cell
  uint32_t nearest;  ///< the distance of its witness there, rounded up
  Witness<uint16_t> witness;
  QueryCursor<uint16_t> cursor;
  Pose pose = Pose::translated(0, 0, 0);
};

/// In place of a variable's number: none.
constexpr uint8_t kNoVariable = 0xFF;

/// Where two links are near each other, and which way is out.
struct [[nodiscard]] PairDetail {
  /// `done`; `guard_state_invalid`: there was no period yet, or no such pair; or a query's error.
  Status status;
  /// Of the two triangles that were nearest when they were last looked at, where they are at the
  /// end of the period, in the base's frame. The links may be nearer elsewhere: distance(), with
  /// `witness` as its hint, measures them.
  NearestPoints nearest;
  TrianglePair<uint16_t> triangles;  ///< by their ids
  Witness<uint16_t> witness;
  /// The one that has most to do with it: that brought the two points nearer by most in this
  /// period; where none did, the one with the greatest share in `changes`. Or kNoVariable.
  uint8_t variable;
};

namespace detail {
constexpr uint32_t at_least_one(uint32_t count) {
  return count != 0 ? count : 1;
}
}  // namespace detail

/// All memory of a guard: plain data without pointers, which may be copied, stored and taken up
/// again (Guard::resume()). A robot's header has the counts.
template <uint32_t joint_count, uint32_t pair_count, uint32_t pair_joint_count>
struct GuardStateOf {
  static constexpr uint32_t kJoints = detail::at_least_one(joint_count);

  GuardCore core;
  JointCoordinate before[kJoints];  ///< the values of the last period
  JointCoordinate step[kJoints];    ///< from there to those of this one
  JointCoordinate next[kJoints];    ///< for frames, and until values are accepted
  JointCoordinate walked[kJoints];  ///< where the measurement began
  Frame frames[kJoints];
  GuardPair pairs[detail::at_least_one(pair_count)];
  JointCoordinate certified[detail::at_least_one(
      pair_joint_count)];  ///< of all joints between, pair after pair
  /// What they move the links where they stood, in (share + 1) / 256 of their reaches (levers.hpp).
  uint8_t shares[detail::at_least_one(pair_joint_count)];
  uint8_t walked_shares[kJoints];  ///< the same of the pair that is being measured
};

/// Of one robot; what it knows lies in the state.
class Guard {
 public:
  /// Knows nothing yet. `robot` and `state` outlive it; the state is written.
  template <uint32_t joint_count, uint32_t pair_count, uint32_t pair_joint_count>
  Guard(const Robot& robot, GuardStateOf<joint_count, pair_count, pair_joint_count>& state)
      : robot_(&robot),
        core_(&state.core),
        before_(state.before),
        step_(state.step),
        next_(state.next),
        walked_(state.walked),
        frames_(state.frames),
        pairs_(state.pairs),
        certified_(state.certified),
        shares_(state.shares),
        walked_shares_(state.walked_shares) {
    fits_ = joint_count >= robot.joint_count && pair_count >= robot.pair_count &&
            pair_joint_count >= joints_between();
    forget();
  }

  /// The same in `size` bytes, as a GuardStateOf of the robot's own counts lies in them.
  Guard(const Robot& robot, void* memory, size_t size)
      : robot_(&robot),
        core_(static_cast<GuardCore*>(memory)),
        before_(reinterpret_cast<JointCoordinate*>(core_ + 1)),
        step_(before_ + robot.joint_count),
        next_(step_ + robot.joint_count),
        walked_(next_ + robot.joint_count),
        frames_(reinterpret_cast<Frame*>(walked_ + robot.joint_count)),
        pairs_(reinterpret_cast<GuardPair*>(frames_ + robot.joint_count)),
        certified_(reinterpret_cast<JointCoordinate*>(pairs_ + robot.pair_count)),
        shares_(reinterpret_cast<uint8_t*>(certified_ + joints_between())),
        walked_shares_(shares_ + joints_between()) {
    const auto begin = reinterpret_cast<uintptr_t>(memory);
    const auto end = reinterpret_cast<uintptr_t>(walked_shares_ + robot.joint_count);
    fits_ = begin % alignof(GuardCore) == 0 && (end - begin + 3) / 4 * 4 <= size;
    forget();
  }

  /// Whether the memory is enough for the robot.
  bool fits() const { return fits_ != 0; }

  /// Forgets all certificates and where the robot was.
  void forget();

  /// Takes the state as it was copied back into its place, and goes on. `guard_state_invalid`, and
  /// all is forgotten, if it is not one of this robot's.
  Status resume();

  /// Stores checksums of the guard, of the robot's view, of its meshes' views and of the whole
  /// state for verify(): after each update() or go_on(), and after the robot's view or a mesh's
  /// changes.
  void seal();

  /// `done`: nothing changed since seal(). `guard_state_invalid`: memory is damaged, or was not
  /// sealed; neither guard nor robot is to be used. Any change within one aligned word of 32 bits
  /// is found, others but for a chance of 2^-32. No pointer is followed before its checksum holds.
  /// The state's checksum has no addresses: of a guard that was sealed before a stored, sealed
  /// state was copied into its place, verify() checks that state.
  ///
  /// Arrays that the views point to are not read: images in flash and a workcell's memory are for
  /// RegionTest (self_test.hpp). On a Cortex-M4F at -O2 both take some 4 instructions
  /// a word, 1,500 for a KUKA KR5 of 6 joints; 96 bytes of stack.
  Status verify() const;

  /// A period: from the last values to these. `values`: variable_count of them. `work`: what may be
  /// spent on measuring, as of queries (query.hpp); it is overdrawn by one step at most, and
  /// looking at all pairs comes on top.
  GuardAnswer update(const JointCoordinate* values, uint32_t work);

  /// The same period, with more work.
  GuardAnswer go_on(uint32_t work);

  /// Of a pair, at the end of the period. `changes`: variable_count of them: how the distance
  /// changes with a unit of each variable, in 2^-kReachBits of 1/256 cell, as reaches are. It grows
  /// where the joint goes up if that is positive. All 0 if the triangles intersect. Changes
  /// nothing; linked only if it is called.
  PairDetail explain(uint16_t pair, int32_t* changes);

  /// All certificates, whatever they take: at start-up, before the first period. The robot stands.
  GuardAnswer prime(const JointCoordinate* values) {
    forget();
    return update(values, UINT32_MAX);
  }

 private:
  struct Found;
  struct Left;
  struct Share;

  uint32_t joints_between() const;
  bool is_possible() const;
  bool has_triangles(uint16_t pair, const Witness<uint16_t>& witness) const;
  Status move_to(const JointCoordinate* values);
  Status measure(const Found& found, uint32_t& work);
  template <class Visit>
  bool for_each_way(const RobotPair& pair, uint32_t first, Visit&& visit) const;
  uint32_t motion_of(const RobotPair& pair, uint32_t first, bool& is_fresh) const;
  uint32_t motion_by_levers(const RobotPair& pair, uint32_t first) const;
  Left left_of(uint16_t pair, uint32_t first, bool by_levers) const;
  uint32_t distance_where_begun(uint16_t pair) const;
  uint32_t moved_in_walk() const;
  uint32_t rate_of(const RobotPair& pair) const;
  uint32_t longest_step() const;
  Found look();
  uint32_t first_between(uint16_t pair) const;
  void begin_walk(uint16_t pair, uint32_t& work);
  bool certify_by_spheres(uint16_t pair, uint32_t rate);
  bool certify_by_table(uint16_t pair, uint32_t rate);
  FLASHBVH_NOINLINE uint32_t witness_distance(uint32_t& work) const;
  uint32_t limit_for(uint16_t pair, uint32_t nearest) const;
  void aim(uint32_t nearest);
  Status walk(uint32_t& work);
  Status finish(const GuardPair& certificate);
  void certify(uint16_t pair, const JointCoordinate* at, const GuardPair& certificate,
               const uint8_t* shares);
  Pose pose_of(const RobotPair& pair) const;
  bool is_free(uint32_t joint) const;
  int32_t step_to_next(uint32_t joint) const;
  bool has_one_way(uint32_t joint) const;
  void set_next();
  void make_frames();
  Share share_of(const RobotPair& pair, uint8_t variable, const NearestPoints& nearest) const;
  bool place_witness(uint16_t pair, const Witness<uint16_t>& witness, const Pose& pose, Triangle& a,
                     Triangle& b) const;
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
  Frame* frames_;
  GuardPair* pairs_;
  JointCoordinate* certified_;
  uint8_t* shares_;
  uint8_t* walked_shares_;
  uint32_t fits_;  ///< 0 or not: checksums are of words without padding
  uint32_t robot_seal_ = 0;
  uint32_t meshes_seal_ = 0;
  uint32_t seal_ = 0;  ///< of all words before it
};

}  // namespace flashbvh

#endif
