// Certified motions on random arms against brute force along the motion.
#include "flashbvh/collide.hpp"
#include "flashbvh/robot/motion.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/test.hpp"

namespace {

using State = MotionStateOf<8, 8>;

bool are_same(const MotionAnswer& u, const MotionAnswer& v) {
  return u.status == v.status && u.outcome == v.outcome &&
         (u.outcome == MotionOutcome::free ||
          (u.pair == v.pair && u.numerator == v.numerator && u.level == v.level &&
           (u.outcome == MotionOutcome::close ||
            (u.triangles.a == v.triangles.a && u.triangles.b == v.triangles.b))));
}

MotionAnswer in_slices(MotionQuery& query, std::uint32_t work) {
  MotionAnswer answer = query.run(work);
  while (answer.status == Status::suspended) {
    answer = query.run(work);
  }
  return answer;
}

/// Whether the pair intersects at the reported moment, as the query places it.
bool is_hit(const FixedArm& arm, const MotionAnswer& answer, const Values& values) {
  const RobotPair& pair = arm.robot().pairs[answer.pair];
  const Values coordinates = coordinates_of(arm.robot(), values);
  if (coordinates.empty()) {
    return false;
  }
  const Pose pose = PlacedLinks(arm.robot(), coordinates).pose(pair.a, pair.b);
  bool found = false;
  (void)for_each_pair(
      arm.robot().meshes[pair.a], arm.robot().meshes[pair.b], pose, [&](const auto& triangles) {
        found = found || (triangles.a == answer.triangles.a && triangles.b == answer.triangles.b);
        return !found;
      });
  return found;
}

void check_free(const FixedArm& arm, const MotionQuery& query) {
  Values values(arm.model.variables.size());
  for (std::uint32_t i = 0; i <= 128; ++i) {
    query.set_values(i, 7, values.data());
    for (std::uint32_t j = 0; j < arm.robot().pair_count; ++j) {
      const RobotPair& pair = arm.robot().pairs[j];
      REQUIRE_FALSE(intersects(arm.robot().meshes[pair.a], arm.robot().meshes[pair.b],
                               arm.exact_pose(pair, values))
                        .yes);
    }
  }
}

void check_reported(const FixedArm& arm, const MotionQuery& query, const MotionAnswer& answer) {
  Values values(arm.model.variables.size());
  query.set_values(answer.numerator, answer.level, values.data());
  if (answer.outcome == MotionOutcome::hit) {
    CHECK(is_hit(arm, answer, values));
  } else {  // adds the placing error of the moment
    CHECK(arm.is_closer(arm.robot().pairs[answer.pair], values, 3 * arm.robot().slack));
  }
}

}  // namespace

TEST_CASE("motions: free all the way, hit where it is reported, the same in any slices") {
  long outcomes[3] = {};
  for_rounds(4, [&](Random& random, int round) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(2), 1e-3);
    const auto state = std::make_unique<State>();
    MotionQuery query(arm.robot(), *state);
    for (int i = 0; i < 40; ++i) {
      CAPTURE(round, i);
      const Values from = arm.any_values(random);
      Values to = arm.any_values(random);
      for (std::size_t k = 0; k < to.size() && i % 2 != 0; ++k) {  // a short motion
        to[k] = from[k] + static_cast<JointCoordinate>((std::int64_t{to[k]} - from[k]) / 20);
      }
      REQUIRE(query.start(from.data(), to.data()) == Status::done);
      const MotionAnswer answer = query.run(UINT32_MAX);
      REQUIRE(answer.status == Status::done);
      ++outcomes[static_cast<int>(answer.outcome)];
      if (answer.outcome == MotionOutcome::free) {
        check_free(arm, query);
      } else {
        check_reported(arm, query, answer);
      }
      for (const std::uint32_t work : {1u, 7u, 1000u}) {
        REQUIRE(query.start(from.data(), to.data()) == Status::done);
        CHECK(are_same(in_slices(query, work), answer));
      }
    }
  });
  CHECK(outcomes[0] > 0);
  CHECK(outcomes[1] > 0);
}

TEST_CASE("motions that are refused") {
  Random random(test_seed());
  const FixedArm arm = any_guarded_arm(random, 3, 1e-3);
  const auto state = std::make_unique<State>();
  MotionQuery query(arm.robot(), *state);
  const Values inside = arm.any_values(random);
  Values wrong = inside;
  wrong[0] = kNoCoordinate;
  CHECK(query.start(inside.data(), wrong.data()) == Status::not_a_coordinate);
  CHECK(query.run(1).status == Status::not_a_coordinate);
  CHECK(query.start(wrong.data(), inside.data()) == Status::not_a_coordinate);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    wrong = inside;
    wrong[i] = arm.joint_of(i).upper + 1;
    CHECK((query.start(inside.data(), wrong.data()) == Status::joint_out_of_limits) !=
          arm.is_free(i));
  }
  MotionStateOf<1, 1> small;
  MotionQuery none(arm.robot(), small);
  CHECK(none.start(inside.data(), inside.data()) == Status::guard_state_invalid);
  CHECK(none.run(1).status == Status::guard_state_invalid);
}

TEST_CASE("a geared mimic of a joint without limits hits what its master never comes near") {
  Model model;
  const std::size_t master = add_joint(model, tool::kNoJoint, {}, JointType::continuous, -kPi, kPi);
  add_mimic(model, master, shifted({0.5, 0, 0}), JointType::continuous, 0, 40, 0);
  // A post that only the mimic's rod reaches, and only during its turns.
  add_link(model, tool::kNoJoint, box({0.5, 0.25, -0.1}, {0.55, 0.28, 0.1}));
  add_link(model, 1, box({0, -0.01, -0.02}, {0.3, 0.01, 0.02}));
  const FixedArm arm(model, 1e-3, {{0, 1, 0, 0}});
  const auto state = std::make_unique<State>();
  MotionQuery query(arm.robot(), *state);
  for (const JointCoordinate turns : {-7, 0, 6}) {
    const JointCoordinate from = turns * kFullTurn;
    const JointCoordinate to = from + kFullTurn / 40;  // times 40: one full turn
    REQUIRE(query.start(&from, &to) == Status::done);
    CHECK(query.run(UINT32_MAX).outcome == MotionOutcome::hit);
  }
}

TEST_CASE("a motion of links so far apart that a query of half of it is undecidable is halved") {
  Model model;
  const Transform forwards = composed(shifted({0.48, 0, 0}), turned(1, kPi / 2));
  const std::size_t slide =
      add_joint(model, tool::kNoJoint, forwards, JointType::prismatic, 0, 0.3);
  add_joint(model, slide, composed(turned(1, -kPi / 2), turned(2, kPi / 4)), JointType::revolute,
            -1, 1);
  add_link(model, tool::kNoJoint, box({-0.16, -0.16, -0.16}, {0.16, 0.16, 0.16}));
  add_link(model, 1, box({-0.16, -0.16, -0.16}, {0.16, 0.16, 0.16}));
  const FixedArm arm(model, 1e-5, {{0, 1, 0.001, 0.002}});
  const JointCoordinate from[] = {0, 0};
  const JointCoordinate to[] = {static_cast<JointCoordinate>(0.22 / arm.unit_of(0)), 0};
  const auto state = std::make_unique<State>();
  MotionQuery query(arm.robot(), *state);
  REQUIRE(query.start(from, to) == Status::done);
  const MotionAnswer answer = query.run(UINT32_MAX);
  CHECK(answer.status == Status::done);
  CHECK(answer.outcome == MotionOutcome::free);
  // The witness cannot be placed there, so the guard reports none.
  AnyGuardState memory;
  Guard guard(arm.robot(), memory);
  CHECK(guard.prime(to).verdict == Verdict::free);
  int32_t changes[2];
  CHECK(guard.explain(0, changes).status == Status::distance_out_of_range);
}
