// The first contact of two bodies on a motion: whether they are apart at every moment, and if not,
// from when to when.
//
// The motion is cut into intervals. In the middle of one the bodies are compared: if they are
// farther apart than anything of B moves until the ends of the interval, they are in all of it. So
// `free` is certified for every moment, of the bodies that the poses place exactly. Where a pose on
// the way is rounded to the lattice, as queries round it, points lie up to 0.9 cells elsewhere: a
// query there may report an intersection if the bodies pass closer than that. A distance of one
// cell (`within`) excludes it, and a larger one keeps the bodies apart by it.
//
// Points, segments, balls, capsules and boxes are bodies, too (shape.hpp), with `within` as radius:
// their motion is a sweep.
//
// Source: Schwarzer, Saha and Latombe, "Adaptive Dynamic Collision Checking" (2005); intervals are
// chosen by the triangles that were nearest in the last one. lib/docs/derivations.md, "Motions of
// two bodies".
#ifndef FLASHBVH_FIRST_CONTACT_HPP
#define FLASHBVH_FIRST_CONTACT_HPP

#include <stdint.h>

#include "flashbvh/body_motion.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/motion/body_reach.hpp"
#include "flashbvh/frame.hpp"
#include "flashbvh/plain/motion_parts.h"
#include "flashbvh/query.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// The most moves of a motion: so that their roundings stay below what decides a contact.
constexpr uint32_t kMostMoves = 64;

/// Of a motion of two bodies.
enum class ContactOutcome : uint8_t {
  free = FLASHBVH_OUTCOME_FREE,
  contact = FLASHBVH_OUTCOME_CONTACT,
  close = FLASHBVH_OUTCOME_CLOSE,
};

namespace detail {

/// Which type an answer has.
template <class Index>
struct ContactAnswerOf {
  /// With wider indices.
  struct [[nodiscard]] Type {
    Status status;
    ContactOutcome outcome;
    TrianglePair<Index> triangles;
    uint32_t from;
    uint32_t to;
  };
};
/// With those of C.
template <>
struct ContactAnswerOf<uint16_t> {
  using Type = flashbvh_first_contact_answer;
};

}  // namespace detail

/// A flashbvh_first_contact_answer, or the same with wider indices.
template <class Index>
using FirstContactAnswerOf = typename detail::ContactAnswerOf<Index>::Type;

/// What a run does next.
enum class ContactPhase : uint8_t {
  at_time,   ///< walks: whether the bodies touch at `time`
  choose,    ///< the next interval, by the hint
  lengthen,  ///< tries the chosen one half as long again
  walk,      ///< whether they come near in it
  done,
};

/// Where a query stands between runs: all there is to keep with its meshes and its motion. May be
/// stored for any time.
template <class Index>
struct [[nodiscard]] FirstContactCursor {
  uint32_t time;  ///< in 2^-30 of the motion: certified, or passed over, up to there
  uint32_t step;  ///< in 2^-30 of the motion: the length of the interval that begins there
  uint32_t near;  ///< the time since when they may be close, or kNever
  QueryCursor<Index> walk;
  Witness<Index> hint;
  Status status;
  ContactOutcome outcome;
  ContactPhase phase;
  uint8_t near_steps;    ///< intervals since then
  uint8_t is_begun;      ///< 1 if time 0 is tested
  uint8_t walks_at_end;  ///< 1 if the end is yet to be tested by a walk

  static constexpr uint32_t kNever = UINT32_MAX;
};

/// The query. 80 bytes on a 32-bit core with 16-bit indices, and a BodyMotion.
///
/// Stack of run() on Cortex-M3 to M55 at -O2: 1,408 bytes. What a unit of work takes is not proven.
template <class MeshType>
class BasicFirstContact {
 public:
  using Mesh = MeshType;
  using Index = typename Mesh::Index;
  using Answer = FirstContactAnswerOf<Index>;
  using Cursor = FirstContactCursor<Index>;

  /// Meshes and motion outlive it. `within`, in 1/256 cell: bodies that come so near touch; 0:
  /// bodies that intersect. Errors show in status() and in every run: those of a query;
  /// `motion_out_of_range`, also of more than kMostMoves; `distance_out_of_range`: beyond
  /// kMaxDistance / 2.
  BasicFirstContact(const Mesh& a, const Mesh& b, const BodyMotion& motion, uint32_t within = 0);
  template <class... With>
  BasicFirstContact(const Mesh&&, const Mesh&, const BodyMotion&, const With&...) = delete;
  template <class... With>
  BasicFirstContact(const Mesh&, const Mesh&&, const BodyMotion&, const With&...) = delete;
  template <class... With>
  BasicFirstContact(const Mesh&, const Mesh&, const BodyMotion&&, const With&...) = delete;

  /// `suspended`: there is something to run; `done`; or its error.
  Status status() const { return at_.status; }

  /// Does at most `work` (query.hpp), overdrawn by one step; UINT32_MAX: all there is to do.
  Answer run(uint32_t work);

  /// After `close`: goes on behind it, as if it were free.
  void pass();

  /// Between runs.
  [[nodiscard]] const Cursor& cursor() const { return at_; }
  /// Goes on from a cursor of a query with the same meshes and motion. `cursor_invalid`, and
  /// nothing changes, if it can't be one.
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
using FirstContact32 = BasicFirstContact<Mesh32>;
using FirstContactAnswer = FirstContact::Answer;

// Compiled once, in the library.
extern template class BasicFirstContact<Mesh>;
extern template class BasicFirstContact<Mesh32>;

}  // namespace flashbvh

#endif
