// First contact of two bodies on a motion: whether they are apart at every moment, and if not, the
// time interval of the contact.
//
// A motion is a start pose and moves. Each move turns the body about an axis and translates it with
// the axis: a straight path, a screw, or a chain of joints. Each move is relative to the moves
// before it, like a joint to its parent. All start and end together and run at constant speed.
//
// `free` is certified for every moment, for bodies placed by exact poses. A query on the way rounds
// its pose to the lattice, which moves points by up to 0.9 cells, and may report an intersection if
// the bodies pass closer; a `within` of one cell excludes this. Shapes (shape.hpp) are bodies too,
// with `within` as a radius.
//
// Source: Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision Checking" (2005);
// lib/docs/derivations.md, "Motions of two bodies".
#pragma once

#include <stdint.h>

#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/motion/body_reach.hpp"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/pose.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/status.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh {

using Move = flashbvh_move;

/// The end of a motion. A time is a binary fraction of the motion; 0 is the start.
constexpr uint32_t kMotionEnd = 1u << 30;
/// Tolerance of an axis: its squared length may differ from 1 by 2^-13, in the fixed point of a
/// rotation. The motion normalises the axis.
constexpr int32_t kAxisTolerance = kRotationOne >> 13;

/// Plain data, constant once made; any number of queries may share it. 188 bytes on a 32-bit core.
class BodyMotion {
 public:
  /// Returns the motion from one pose to another. B's origin moves straight, and B turns about it
  /// at constant speed the shorter way; by half a turn, either way. Both ends are as given. The
  /// path follows the moves: if matrices are not exact rotations, it ends slightly off `to`, and
  /// FirstContact adds that to the distance. Instructions on a Cortex-M4 at -O2: 4,700; for
  /// translations 1,600 (lib/docs/figures.md).
  static BodyMotion between(const Pose& from, const Pose& to);

  /// Makes a motion of `count` moves, which must outlive it, from the outermost to the innermost:
  /// for a chain of joints, from the base to the body. If an arm carries A, A's moves come before
  /// B's, in reverse order and with reverse signs. `not_a_rotation`: an axis' length is not 1.
  BodyMotion(const Pose& from, const Move* moves, uint32_t count);

  /// `done`, or the error that queries return; for poses, their own. `motion_out_of_range`: B's
  /// origin may get farther than 2^19 cells from A's frame, by the sum of the lengths of all
  /// translations and points, points counted twice.
  Status status() const { return is_made_ ? status_ : Status::not_open; }

  /// Returns B's pose at `time`, up to kMotionEnd: as given or made at both ends, in between within
  /// 2^-6 cell of the exact path. Instructions on a Cortex-M4 at -O2 for one move: 1,000 if it
  /// turns, else 650 (lib/docs/figures.md).
  Pose pose_at(uint32_t time) const;

  /// Returns the number of moves; 1 between two poses.
  uint32_t move_count() const { return count_; }
  /// Returns a move, from the outermost to the innermost. `i`: below move_count().
  const Move& move(uint32_t i) const { return moves_ == nullptr ? own_ : moves_[i]; }
  /// Returns B's pose at the start.
  const Pose& from() const { return from_; }
  /// Returns B's pose at the end.
  const Pose& to() const { return to_; }

 private:
  BodyMotion(const Pose& from, const Pose& to);
  void check();

  Pose from_;
  Pose to_;
  const Move* moves_;  ///< null: `own_` is the move
  Move own_;
  uint32_t count_;
  Status status_;
  bool is_made_ = true;  ///< false for an object of zeros, which no constructor made
};

/// Most moves of a motion: their rounding errors then stay below the limit that decides a contact.
constexpr uint32_t kMostMoves = 64;
/// Largest `within` of a motion, in 1/256 cell.
constexpr uint32_t kMaxMotionDistance = 32'000 * 256;

/// Outcomes of a motion of two bodies.
enum class ContactOutcome : uint8_t {
  free = FLASHBVH_OUTCOME_FREE,
  contact = FLASHBVH_OUTCOME_CONTACT,
  close = FLASHBVH_OUTCOME_CLOSE,
};

namespace detail {

/// Selects an answer's type by the index type.
template <class Index>
struct ContactAnswerOf {
  /// The type with wider indices.
  struct [[nodiscard]] Type {
    Status status;
    ContactOutcome outcome;
    TrianglePair<Index> triangles;
    uint32_t from;
    uint32_t to;
  };
};
/// The type that C has too.
template <>
struct ContactAnswerOf<uint16_t> {
  using Type = flashbvh_first_contact_answer;
};

}  // namespace detail

/// A flashbvh_first_contact_answer, or a struct of equal fields with wider indices.
template <class Index>
using FirstContactAnswerOf = typename detail::ContactAnswerOf<Index>::Type;

/// The next step of a run.
enum class ContactPhase : uint8_t {
  at_time,   ///< walks: do the bodies touch at `time`?
  choose,    ///< chooses the next interval by the hint
  lengthen,  ///< tries an interval longer by half
  walk,      ///< walks: do the bodies come near in the interval?
  done,
};

/// A query's cursor between runs: with the meshes and the motion all that is needed to resume. May
/// be stored for any time.
template <class Index>
struct [[nodiscard]] FirstContactCursor {
  uint32_t time;        ///< in 2^-30 of the motion: certified or passed over up to here
  uint32_t step;        ///< in 2^-30 of the motion: length of the interval that begins there
  uint32_t near_since;  ///< start of the time in which they may be close, or kNever
  QueryCursor<Index> walk;
  Witness<Index> hint;
  Status status;
  ContactOutcome outcome;
  ContactPhase phase;
  uint8_t near_steps;    ///< intervals since `near_since`
  uint8_t is_begun;      ///< 1 if time 0 is tested
  uint8_t walks_at_end;  ///< 1 if a walk has yet to test the end

  static constexpr uint32_t kNever = UINT32_MAX;
};

/// The query. 80 bytes on a 32-bit core with 16-bit indices, without its BodyMotion.
///
/// Stack of run() on Cortex-M3 to M55 at -O2: 1,408 bytes. No time of a unit of work is proven.
template <class MeshType>
class BasicFirstContact {
 public:
  using Mesh = MeshType;
  using Index = typename Mesh::Index;
  using Answer = FirstContactAnswerOf<Index>;
  using Cursor = FirstContactCursor<Index>;

  /// Meshes and motion must outlive the query. `within`: bodies this near are in contact; 0: only
  /// bodies that intersect. status() and every run return errors: those of a Query;
  /// `motion_out_of_range`, also for more than kMostMoves, if a point of B may get farther than
  /// 2^19 cells or by a path of 2^25, or if a coordinate of a mesh's origin is 2^18 cells or more;
  /// `distance_out_of_range`: `within` is beyond kMaxMotionDistance.
  BasicFirstContact(const Mesh& a, const Mesh& b, const BodyMotion& motion,
                    FineLength within = {0});
  template <class... With>
  BasicFirstContact(const Mesh&&, const Mesh&, const BodyMotion&, const With&...) = delete;
  template <class... With>
  BasicFirstContact(const Mesh&, const Mesh&&, const BodyMotion&, const With&...) = delete;
  template <class... With>
  BasicFirstContact(const Mesh&, const Mesh&, const BodyMotion&&, const With&...) = delete;

  /// `suspended` while there is work left; `done`; or the query's error.
  Status status() const { return a_ == nullptr ? Status::not_open : at_.status; }

  /// Does at most `work` (query.hpp), overdrawn by one step; UINT32_MAX: no limit.
  Answer run(uint32_t work);

  /// After `close`: continues behind it, as if it were free.
  void pass();
  /// Returns how near the bodies come, at most, if the outcome is `close`; in 1/256 cell. It is
  /// `within`, two cells, and twice the error of the path: 1/128 to 1/14 cell for each move, and
  /// how far inexact matrices miss a motion's end. Valid for a query without an error.
  [[nodiscard]] uint32_t close_distance() const {
    return within_ + 2 * kFineOne + 2 * reach_.path_error();
  }

  /// Returns the cursor. Valid between runs.
  [[nodiscard]] const Cursor& cursor() const { return at_; }
  /// Resumes from the cursor of a suspended query with equal meshes and motion; after `close`, call
  /// pass() before cursor(). `cursor_invalid`, and nothing changes, if no such query can have it.
  Status resume(const Cursor& at);

 private:
  Status prepare();
  uint32_t margin_in(uint32_t step) const;
  uint32_t distance_in(uint32_t step, Frame& frame) const;
  bool is_shortest(uint32_t distance) const;
  bool is_apart(const Witness<Index>& slots, const Frame& frame, uint32_t distance) const;
  detail::PackedVector direction_at(const Frame& frame) const;
  bool may_touch(uint32_t step, uint32_t& distance) const;
  void choose();
  void lengthen();
  void come_near(uint32_t distance);
  void certify();
  void go_on();
  void end(ContactOutcome outcome);
  template <class Query, class Take>
  Status walk(Query&& query, uint32_t& work, const Take& take);
  void walk_at_time(uint32_t& work);
  void walk_interval(uint32_t& work);
  void step(uint32_t& work);

  const Mesh* a_;
  const Mesh* b_;
  const BodyMotion* motion_;
  uint32_t within_;
  detail::BodyReach reach_;
  Cursor at_;
};

using FirstContact = BasicFirstContact<Mesh>;
using FirstContactAnswer = FirstContact::Answer;

// Compiled once, in the library.
extern template class BasicFirstContact<Mesh>;
extern template class BasicFirstContact<Mesh32>;

}  // namespace flashbvh

#pragma GCC diagnostic pop
