// Motions of a body, and first contacts.
#include "c_api/scene.hpp"
#include "flashbvh/first_contact.h"
#include "flashbvh/first_contact.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {
namespace {

constexpr std::uint32_t kMostMoves = 3;

Move any_move(Random& random) {
  Move move = {};
  const Rotation axes = rotation_of(any_quaternion(random));
  for (int i = 0; i < 3; ++i) {
    move.point[i] = random.between(-40, 40) * kFrameCell;
    move.axis[i] = axes.entry[0][i];
    move.travel[i] = random.between(-60, 60) * kFrameCell;
  }
  move.axis[0] += random.below(20) == 0 ? kRotationOne / 9 : 0;
  move.travel[1] += random.below(20) == 0 ? kMaxFrameTranslation : 0;
  move.turn = random.below(3) == 0 ? 0 : random.between(-kFullTurn, kFullTurn);
  return move;
}

/// A motion in both languages, of two poses or of moves stored here.
struct Motions {
  Move moves[kMostMoves];
  BodyMotion motion;
  flashbvh_body_motion c;
  bool agree;

  explicit Motions(Scene& s) : moves(), motion(made(s)) {}

 private:
  BodyMotion made(Scene& s) {
    if (s.random.below(2) == 0) {
      const Pose to = any_rigid_pose(s.random, 60);
      const flashbvh_pose c_to = c_pose_of(to);
      const BodyMotion between = BodyMotion::between(s.pose, to);
      agree = same(flashbvh_body_motion_between(&s.c_pose, &c_to, &c), between.status());
      return between;
    }
    const std::uint32_t count = s.random.below(kMostMoves + 1);
    for (Move& move : moves) {
      move = any_move(s.random);
    }
    const BodyMotion of_moves(s.pose, moves, count);
    agree = same(flashbvh_body_motion_of_moves(&s.c_pose, moves, count, &c), of_moves.status());
    return of_moves;
  }
};

bool motions_agree(Scene& s) {
  const Motions both(s);
  bool agree = both.agree;
  const std::uint32_t times[] = {0, s.random.below(kMotionEnd), FLASHBVH_MOTION_END};
  for (const std::uint32_t time : times) {
    flashbvh_pose pose;
    const Pose wanted = both.motion.pose_at(time);
    agree = agree && same(flashbvh_body_motion_pose(&both.c, time, &pose), wanted.status()) &&
            same(pose, wanted);
  }
  return agree;
}

bool same_answer(const flashbvh_first_contact_answer& c, const FirstContactAnswer& answer) {
  if (answer.status == Status::done) {
    seen_outcomes |= 1u << static_cast<unsigned>(c.outcome);
  }
  return same(static_cast<flashbvh_status>(c.status), answer.status) &&
         c.outcome == answer.outcome && same(c.triangles, answer.triangles) &&
         c.from == answer.from && c.to == answer.to;
}

/// A query and its counterpart, moved to other objects.
struct Contacts {
  Scene& scene;
  const Motions& motions;
  std::uint32_t within;
  FirstContact query{scene.a.mesh, scene.b.mesh, motions.motion, {within}};
  flashbvh_first_contact_query c{};

  bool start() {
    return same(flashbvh_first_contact_start(&c, &scene.a.c, &scene.b.c, &motions.c, {within}),
                query.status());
  }

  /// Resumes by cursors in new objects, after a wrong one; only a suspended query accepts one.
  bool move() {
    const FirstContact::Cursor at = query.cursor();
    const flashbvh_contact_cursor c_at = flashbvh_first_contact_cursor(&c);
    FirstContact::Cursor wrong = at;
    flashbvh_contact_cursor c_wrong = c_at;
    wrong.time ^= scene.random.below(2);
    std::memcpy(&c_wrong, &wrong, sizeof wrong);
    query = FirstContact(scene.a.mesh, scene.b.mesh, motions.motion, {within});
    wipe(c);
    return start() && same(flashbvh_first_contact_resume(&c, &c_wrong), query.resume(wrong)) &&
           same(flashbvh_first_contact_resume(&c, &c_at), query.resume(at));
  }
};

bool first_contact_agrees(Scene& s) {
  const Motions motions(s);
  const std::uint32_t within = s.random.below(2) == 0   ? 0
                               : s.random.below(8) == 0 ? kMaxMotionDistance + s.random.below(2)
                                                        : s.random.below(600);
  Contacts both = {s, motions, within};
  bool agree = both.start();
  for (std::uint32_t passes = 0; agree;) {
    const std::uint32_t work = s.random.below(4) == 0 ? UINT32_MAX : 1 + s.random.below(900);
    const FirstContactAnswer answer = both.query.run(work);
    agree = same_answer(flashbvh_first_contact_run(&both.c, work), answer);
    if (answer.status == Status::suspended) {
      agree = agree && both.move();
    } else if (answer.outcome == ContactOutcome::close && ++passes < 9) {
      both.query.pass();
      flashbvh_first_contact_pass(&both.c);
    } else {
      return agree;
    }
  }
  return false;
}

}  // namespace

std::vector<Row> motion_rows() {
  return {{"motions", motions_agree}, {"first contacts in slices", first_contact_agrees}};
}

}  // namespace flashbvh::test
