// Checks that guards, motions and workcells refuse everything.
#pragma once

#include <catch2/catch.hpp>

#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/motion.hpp"
#include "flashbvh/robot/workcell.hpp"

namespace flashbvh::test {

inline bool is_refused(const GuardAnswer& answer) {
  return answer.status == Status::not_open && answer.verdict == Verdict::refused;
}

inline void check_refused(Guard& guard, const JointCoordinate* values) {
  int32_t changes[kMaxJoints];
  CHECK(guard.status() == Status::not_open);
  CHECK_FALSE(guard.fits());
  CHECK(is_refused(guard.prime(values)));
  CHECK(is_refused(guard.update(values, UINT32_MAX)));
  CHECK(is_refused(guard.go_on(UINT32_MAX)));
  CHECK(guard.resume() == Status::not_open);
  CHECK(guard.explain(0, changes).status == Status::not_open);
  guard.forget();
  guard.seal();
  CHECK(guard.verify() == Status::not_open);
}

inline void check_refused(MotionQuery& motion, const JointCoordinate* values) {
  JointCoordinate none[1] = {77};
  CHECK(motion.status() == Status::not_open);
  CHECK_FALSE(motion.fits());
  CHECK(motion.run(UINT32_MAX).status == Status::not_open);
  CHECK(motion.start(values, values) == Status::not_open);
  const MotionAnswer answer = motion.run(UINT32_MAX);
  CHECK(answer.status == Status::not_open);
  CHECK(answer.outcome != MotionOutcome::free);
  motion.set_values(0, 0, none);
  CHECK(none[0] == 77);
}

inline void check_refused(Workcell& workcell, const Mesh& body) {
  uint8_t link = 77;
  CHECK(workcell.status() == Status::not_open);
  CHECK_FALSE(workcell.fits());
  CHECK(workcell.add(body, {kBase, kIdentityFrame}, link) == Status::not_open);
  CHECK(workcell.keep_apart(0, 1, {5}, {9}) == Status::not_open);
  CHECK(workcell.move(0, kIdentityFrame, {0}) == Status::not_open);
  CHECK(link == 77);
}

}  // namespace flashbvh::test
