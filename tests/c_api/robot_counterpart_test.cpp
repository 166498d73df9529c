// Each robot function in C against its C++ counterpart, on the arm of
// firmware_examples/robot_guard.
#include <catch2/catch.hpp>

#include <string.h>

#include "c_arm.robot.h"
#include "flashbvh/robot.h"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/motion.hpp"
#include "flashbvh/robot/robot_float.hpp"
#include "flashbvh/robot/workcell.hpp"
#include "support/random.hpp"
#include "support/same_view.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr uint32_t kVariables = 4;
constexpr flashbvh_workcell_room kRoom = {6, 8, 11, 16};
using Memory = WorkcellOf<6, 8, 11, 16>;
using State = GuardStateOf<6, 11, 41>;
static_assert(sizeof(Memory) == FLASHBVH_WORKCELL_SIZE(6, 8, 11, 16), "as in C");
static_assert(sizeof(State) == FLASHBVH_GUARD_STATE_SIZE(6, 11, 41), "as in C");

bool same(flashbvh_status c, Status status) {
  return c == static_cast<flashbvh_status>(status);
}
bool same(const GuardAnswer& c, const GuardAnswer& answer) {
  return memcmp(&c, &answer, sizeof c) == 0;
}
template <class Element>
bool same(const Element* p, const Element* q, uint32_t count) {
  return memcmp(p, q, count * sizeof *p) == 0;
}
bool same(const NearestPoints& c, const NearestPoints& known) {
  return same(&c.point_a, &known.point_a, 1) && same(&c.point_b, &known.point_b, 1) &&
         same(&c.direction, &known.direction, 1) && c.lower == known.lower &&
         c.upper == known.upper;
}
bool same(const MotionAnswer& c, const MotionAnswer& answer) {
  return c.status == answer.status && c.outcome == answer.outcome && c.pair == answer.pair &&
         c.numerator == answer.numerator && c.level == answer.level &&
         (answer.outcome != MotionOutcome::hit || same(&c.triangles, &answer.triangles, 1));
}
Mesh meshes[c_arm_LINK_COUNT];
const Robot robot = view_robot_unchecked(c_arm_robot_image, meshes);

/// Values that move by steps that a guard accepts, and sometimes jump, exceed a limit, or are no
/// number.
struct Values {
  float floats[kVariables] = {0, 0.3f, 1, 0};
  JointCoordinate values[kVariables];

  void move_on(Random& random) {
    if (floats[random.below(kVariables)] > 6) {
      floats[0] = floats[1] = floats[2] = floats[3] = 0.2f;
    }
    const auto i = random.below(kVariables);
    floats[i] += static_cast<float>(random.between(-100, 100)) / 1000;
    if (random.below(12) == 0) {
      floats[i] = static_cast<float>(random.between(-40, 40)) / 10;
    }
    if (random.below(12) == 0) {
      floats[i] = 1e30f;
    }
    set_values(robot, floats, values);
  }
};

void check_explained(flashbvh_guard& c, Guard& guard, uint16_t pair) {
  int32_t changes[kVariables] = {};
  int32_t c_changes[kVariables] = {};
  flashbvh_pair_detail found;
  const PairDetail known = guard.explain(pair, changes);
  REQUIRE(same(flashbvh_guard_explain(&c, pair, c_changes, &found), known.status));
  REQUIRE(found.variable == known.variable);
  if (known.status == Status::done) {
    REQUIRE(same(changes, c_changes, kVariables));
    REQUIRE(same(found.nearest, known.nearest));
    REQUIRE(same(&found.triangles, &known.triangles, 1));
    REQUIRE(found.witness.a == known.witness.a);
    REQUIRE(found.witness.b == known.witness.b);
  }
}

/// Sends a command to both, and sometimes releases a pair.
void check_limited(flashbvh_guard& c, Guard& guard, const JointCoordinate* wanted, Random& random) {
  const auto pair =
      static_cast<uint16_t>(random.below(4) == 0 ? kNoPair : random.below(c_arm_PAIR_COUNT));
  const FineLength most = {random.below(10) == 0 ? UINT32_MAX : random.below(1000)};
  if (random.below(20) == 0) {
    REQUIRE(same(flashbvh_guard_release(&c, pair, most), guard.release(pair, most)));
  }
  JointCoordinate granted[kVariables] = {};
  JointCoordinate c_granted[kVariables] = {};
  const uint32_t work = random.below(200);
  const LimitAnswer known = guard.limit(wanted, granted, work);
  const LimitAnswer found = flashbvh_guard_limit(&c, wanted, c_granted, work);
  REQUIRE((found.status == known.status && found.verdict == known.verdict));
  REQUIRE((found.share == known.share && found.pair == known.pair && found.work == known.work));
  REQUIRE((found.opposed == known.opposed && found.floor == known.floor));
  REQUIRE(found.distance == known.distance);
  REQUIRE(same(granted, c_granted, kVariables));
}

/// Runs a period, and more work for it; returns its worst verdict.
uint32_t check_period(flashbvh_guard& c, Guard& guard, Values& at, Random& random) {
  at.move_on(random);
  const uint32_t work = random.below(60);
  GuardAnswer answer = guard.update(at.values, work);
  REQUIRE(same(flashbvh_guard_update(&c, at.values, work), answer));
  const uint32_t seen = 1u << static_cast<uint32_t>(answer.verdict);
  if (random.below(2) == 0) {
    const uint32_t more = random.below(2) == 0 ? UINT32_MAX : 9;
    answer = guard.go_on(more);
    REQUIRE(same(flashbvh_guard_go_on(&c, more), answer));
  }
  check_explained(c, guard, random.below(4) == 0 ? kNoPair : answer.pair);
  check_limited(c, guard, at.values, random);
  return seen | 1u << static_cast<uint32_t>(answer.verdict);
}

}  // namespace

TEST_CASE("an image opens in C as in C++, and is viewed as it opens") {
  flashbvh_mesh c_meshes[c_arm_LINK_COUNT];
  constexpr size_t size = sizeof c_arm_robot_image;
  flashbvh_robot opened;
  CHECK(flashbvh_open_robot(c_arm_robot_image, size - 1, c_meshes, c_arm_LINK_COUNT, &opened) ==
        FLASHBVH_STATUS_IMAGE_TRUNCATED);
  CHECK(flashbvh_open_robot(c_arm_robot_image, size, c_meshes, c_arm_LINK_COUNT - 1, &opened) ==
        FLASHBVH_STATUS_IMAGE_TOO_LARGE);
  REQUIRE(flashbvh_open_robot(c_arm_robot_image, size, c_meshes, c_arm_LINK_COUNT, &opened) ==
          FLASHBVH_STATUS_DONE);
  CHECK(same_view(opened, robot));
  flashbvh_view_robot_unchecked(c_arm_robot_image, c_meshes, &opened);
  CHECK(same_view(opened, robot));
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    CHECK(flashbvh_joint_name(c_arm_robot_image, i) == joint_name(c_arm_robot_image, i));
  }
  for (uint32_t i = 0; i < robot.link_count; ++i) {
    CHECK(flashbvh_link_name(c_arm_robot_image, i) == link_name(c_arm_robot_image, i));
  }
  uint32_t mount_number = 0;
  uint32_t unguarded = 99;
  CHECK(flashbvh_mounts(c_arm_robot_image, &mount_number) == mounts(c_arm_robot_image));
  CHECK(mount_number == mount_count(c_arm_robot_image));
  CHECK(flashbvh_unguarded_pairs(c_arm_robot_image, &unguarded) ==
        unguarded_pairs(c_arm_robot_image));
  CHECK(unguarded == c_arm_UNGUARDED_COUNT);
}

TEST_CASE("floats become equal values and frames in C and C++") {
  Random random(test_seed() + 40);
  Values at;
  for (int round = 0; round < 60; ++round) {
    at.move_on(random);
    JointCoordinate values[kVariables];
    flashbvh_set_values(&robot, at.floats, values);
    REQUIRE(same(values, at.values, kVariables));
    const float rows[3][3] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    const float metres[3] = {at.floats[round % 4] / 8, -0.2f, round % 9 == 0 ? 1e6f : 0.3f};
    Frame turned;
    Frame c_turned;
    REQUIRE(same(flashbvh_set_frame_of_matrix(&robot, rows[0], metres, &c_turned),
                 set_frame(robot, rows, metres, turned)));
    REQUIRE(same(&turned, &c_turned, 1));
  }
}

TEST_CASE("a guard in C answers as in C++, also after its state was damaged") {
  Random random(test_seed() + 41);
  Values at;
  flashbvh_guard c;
  State state;
  State c_state;
  uint32_t verdicts = 0;
  at.move_on(random);
  REQUIRE(flashbvh_guard_init(&c, &robot, &c_state, sizeof c_state) == FLASHBVH_STATUS_DONE);
  Guard guard(robot, &state, sizeof state);
  check_explained(c, guard, 0);  // before the first period
  const GuardAnswer first = guard.prime(at.values);
  REQUIRE(same(flashbvh_guard_update(&c, at.values, UINT32_MAX), first));
  for (int period = 0; period < 400; ++period) {
    verdicts |= check_period(c, guard, at, random);
    if (random.below(20) == 0) {
      memcpy(static_cast<void*>(&state), &c_state, sizeof state);  // C++ continues from C's state
    }
    if (random.below(20) == 0) {
      guard.seal();
      flashbvh_guard_seal(&c);
      memcpy(static_cast<void*>(&state), &c_state, sizeof state);  // C++ verifies what C sealed
      REQUIRE(guard.verify() == Status::done);
      REQUIRE(flashbvh_guard_verify(&c) == FLASHBVH_STATUS_DONE);
      reinterpret_cast<char*>(&c_state)[random.below(c_arm_GUARD_STATE_SIZE)] ^= 16;
      REQUIRE(flashbvh_guard_verify(&c) == FLASHBVH_STATUS_GUARD_STATE_INVALID);
      memcpy(static_cast<void*>(&c_state), &state, sizeof state);
    }
  }
  CHECK(verdicts == 0x3F);
}

TEST_CASE("certified motions in C are those of C++") {
  Random random(test_seed() + 42);
  Values from;
  Values to;
  flashbvh_motion c;
  State state;
  State c_state;
  uint32_t outcomes = 0;
  REQUIRE(flashbvh_motion_init(&c, &robot, &c_state, sizeof c_state) == FLASHBVH_STATUS_DONE);
  MotionQuery motion(robot, &state, sizeof state);
  for (int round = 0; round < 12; ++round) {
    to.floats[2] = round % 2 == 0 ? 2.9f : 0.5f;
    from.move_on(random);
    to.move_on(random);
    REQUIRE(same(flashbvh_motion_start(&c, from.values, to.values),
                 motion.start(from.values, to.values)));
    MotionAnswer answer{};
    do {
      const uint32_t work = 1 + random.below(200);
      answer = motion.run(work);
      REQUIRE(same(flashbvh_motion_run(&c, work), answer));
    } while (answer.status == Status::suspended);
    if (answer.status == Status::done) {
      outcomes |= 1u << static_cast<uint32_t>(answer.outcome);
    }
  }
  CHECK((outcomes & 3) == 3);
}

TEST_CASE("a workcell in C is that of C++, and so is its guard") {
  Memory memory;
  Memory c_memory;
  State state;
  State c_state;
  Random random(test_seed() + 43);
  for (int round = 0; round < 8; ++round) {
    flashbvh_workcell c;
    REQUIRE(flashbvh_workcell_init(&c, &robot, &c_memory, sizeof c_memory, &kRoom) ==
            FLASHBVH_STATUS_DONE);
    Workcell cell(robot, memory);
    for (int body = 0; body < 3; ++body) {
      const uint32_t link = random.below(c_arm_LINK_COUNT);
      Mount mount = body == 0 ? mounts(c_arm_robot_image)[c_arm_mount_gripper]
                              : mounts(c_arm_robot_image)[c_arm_mount_base];
      mount.joint = body == 2 ? static_cast<uint8_t>(random.below(9)) : mount.joint;
      mount.frame.rotation[0][0] /= random.below(4) == 0 ? 2 : 1;
      mount.frame.translation[2] += random.between(0, 1 << (random.below(5) == 0 ? 30 : 20));
      uint8_t number = 77;
      uint8_t c_number = 77;
      const Status status = cell.add(robot.meshes[link], mount, number);
      const auto* const mesh = reinterpret_cast<const flashbvh_mesh*>(&robot.meshes[link]);
      REQUIRE(same(flashbvh_workcell_add(&c, mesh, &mount, &c_number), status));
      REQUIRE(c_number == number);
      for (uint8_t other = 0; other < 7; ++other) {
        const uint32_t warn = random.below(9) == 0 ? kMaxGuardDistance + 1 : random.below(200000);
        const uint32_t stop = random.below(200000);
        REQUIRE(same(flashbvh_workcell_keep_apart(&c, other, number, {stop}, {warn}),
                     cell.keep_apart(other, number, {stop}, {warn})));
      }
      const uint32_t moved = random.below(9) == 0 ? UINT32_MAX : random.below(9999);
      REQUIRE(same(flashbvh_workcell_move(&c, number, &mount.frame, {moved}),
                   cell.move(number, mount.frame, {moved})));
    }
    REQUIRE(same_view(*flashbvh_workcell_robot(&c), cell.robot()));
    flashbvh_guard c_guard;
    REQUIRE(flashbvh_guard_init(&c_guard, flashbvh_workcell_robot(&c), &c_state, sizeof c_state) ==
            FLASHBVH_STATUS_DONE);
    Guard guard(cell.robot(), state);
    Values at;
    for (int period = 0; period < 20; ++period) {
      (void)check_period(c_guard, guard, at, random);
    }
  }
}

TEST_CASE("memory that is too small or not aligned is refused by init and by every later call") {
  struct Row {
    uint32_t offset;
    size_t size;
    flashbvh_workcell_room room;
  };
  const size_t of_cell = FLASHBVH_WORKCELL_SIZE(4, 6, 6, 10);
  const flashbvh_workcell_room room = {4, 6, 6, 10};
  const Row rows[] = {{0, of_cell - 8, room},
                      {4, of_cell, room},
                      {0, of_cell, {3, 6, 6, 10}},
                      {0, of_cell, {4, 5, 6, 10}},
                      {0, of_cell, {4, 6, 5, 10}},
                      {0, of_cell, {4, 6, 6, 9}},
                      {0, of_cell, {4, 6, 6, UINT32_MAX}}};
  Memory memory;
  auto* const bytes = reinterpret_cast<char*>(&memory);
  flashbvh_workcell cell;
  CHECK(flashbvh_workcell_init(&cell, &robot, bytes, of_cell, &room) == FLASHBVH_STATUS_DONE);
  for (const Row& row : rows) {
    uint8_t link = 77;
    CHECK(flashbvh_workcell_init(&cell, &robot, bytes + row.offset, row.size, &row.room) ==
          FLASHBVH_STATUS_WORKCELL_FULL);
    CHECK(flashbvh_workcell_add(&cell, reinterpret_cast<const flashbvh_mesh*>(robot.meshes),
                                &mounts(c_arm_robot_image)[c_arm_mount_base],
                                &link) == FLASHBVH_STATUS_WORKCELL_FULL);
    CHECK(link == 77);
  }
  const JointCoordinate values[kVariables] = {};
  const Status invalid = Status::guard_state_invalid;
  alignas(State) static char state[sizeof(State)];
  for (uint32_t offset = 0; offset <= 2; offset += 2) {
    const uint32_t less = offset == 0 ? 4 : 0;  // a guard's last three bytes may be padding
    flashbvh_guard guard;
    flashbvh_motion motion;
    CHECK(same(flashbvh_guard_init(&guard, &robot, state + offset, c_arm_GUARD_STATE_SIZE - less),
               invalid));
    CHECK(flashbvh_guard_update(&guard, values, 1).verdict == Verdict::refused);
    CHECK(flashbvh_guard_go_on(&guard, 1).status == invalid);
    CHECK(
        same(flashbvh_motion_init(&motion, &robot, state + offset, c_arm_MOTION_STATE_SIZE - less),
             invalid));
    CHECK(same(flashbvh_motion_start(&motion, values, values), invalid));
    CHECK(flashbvh_motion_run(&motion, 1).status == invalid);
  }
  for (const char byte : state) {
    REQUIRE(byte == 0);  // a refused object is not written
  }
}
