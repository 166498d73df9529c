// The robot's story in C++: each function does what robot_program.c's of the same name does.
#include <string.h>
#include <flashbvh/robot/motion.hpp>
#include <flashbvh/robot/robot_float.hpp>
#include <flashbvh/robot/workcell.hpp>

#include "cell_arm.robot.hpp"
#include "robot.h"

using namespace flashbvh;
using cell_arm::kJointCount;

namespace {

static_assert(sizeof(cell_arm::GuardState) == FLASHBVH_GUARD_STATE_SIZE(4, 6, 18), "as in C");

cell_arm::GuardState state;

/// From that word on.
template <class Memory>
Memory& in_scratch(uint32_t word) {
  void* const memory = scratch + word;
  return *static_cast<Memory*>(memory);
}

void tell(story* to, Status status) {
  ::tell(to, static_cast<uint32_t>(status));
}
using ::tell;

void tell_of(story* to, const GuardAnswer& answer) {
  tell_answer(to, answer);
}

void tell_of(story* to, Guard& guard, uint16_t pair) {
  int32_t changes[VARIABLES];
  const PairDetail d = guard.explain(pair, changes);
  const flashbvh_pair_detail detail = {
      d.nearest, d.triangles, {d.witness.a, d.witness.b}, d.variable};
  tell(to, d.status);
  tell_detail(to, &detail, changes);
}

void values_at(int motion, int period, JointCoordinate* values) {
  float joints[VARIABLES];
  set_point(motion, period, joints);
  set_values(cell_arm::robot, joints, values);
}

GuardAnswer tell_period(Guard& guard, int motion, int period, story* to) {
  JointCoordinate values[VARIABLES];
  values_at(motion, period, values);
  GuardAnswer answer = guard.update(values, GUARD_WORK);
  tell_of(to, answer);
  if (answer.verdict == Verdict::not_yet_known) {
    answer = guard.go_on(UINT32_MAX);
    tell_of(to, answer);
  }
  return answer;
}

Status put_ball(int period, Frame& frame) {
  float numbers[9];
  float metres[3];
  float rotation[3][3];
  set_ball(period, numbers, metres);
  memcpy(rotation, numbers, sizeof rotation);
  return set_frame(cell_arm::robot, rotation, metres, frame);
}

template <class Element>
bool same(const Element* p, const Element* q, uint32_t count) {
  return memcmp(p, q, count * sizeof *p) == 0;
}

bool same_mesh(const PostMesh& p, const PostMesh& q) {
  return p.node_count == q.node_count && p.leaf_count == q.leaf_count &&
         p.stack_need == q.stack_need && p.triangle_count == q.triangle_count &&
         p.vertex_count == q.vertex_count && p.shell_count == q.shell_count &&
         p.longest_edge == q.longest_edge && p.unit == q.unit && p.is_closed == q.is_closed &&
         p.cell_bits == q.cell_bits && same(p.origin, q.origin, 3) &&
         same(p.nodes, q.nodes, p.node_count) && same(p.triangles, q.triangles, p.triangle_count) &&
         same(p.triangle_ids, q.triangle_ids, p.triangle_count) &&
         same(p.vertices, q.vertices, p.vertex_count) &&
         same(p.shell_vertices, q.shell_vertices, p.shell_count) &&
         (p.leaf_offsets == nullptr) == (q.leaf_offsets == nullptr) &&
         (p.leaf_offsets == nullptr || same(p.leaf_offsets, q.leaf_offsets, p.leaf_count + 1u));
}

}  // namespace

bool is_robot_of_cpp(const flashbvh_robot* robot) {
  const Robot& c = *reinterpret_cast<const Robot*>(robot);
  const Robot& cpp = cell_arm::robot;
  bool is_same =
      c.joint_count == cpp.joint_count && c.link_count == cpp.link_count &&
      c.variable_count == cpp.variable_count && c.pair_count == cpp.pair_count &&
      c.reach_count == cpp.reach_count && c.chart_bytes == cpp.chart_bytes &&
      same(c.charts, cpp.charts, cpp.chart_bytes) && c.slack == cpp.slack && c.hash == cpp.hash &&
      c.cell_bits == cpp.cell_bits && same(c.joints, cpp.joints, cpp.joint_count) &&
      same(c.links, cpp.links, cpp.link_count) && same(c.pairs, cpp.pairs, cpp.pair_count) &&
      same(c.reaches, cpp.reaches, cpp.reach_count);
  for (uint32_t i = 0; i < cpp.link_count; ++i) {
    is_same = is_same && same_mesh(c.meshes[i], cpp.meshes[i]);
  }
  return is_same;
}

void kinematics_in_cpp(story* to) {
  JointCoordinate coordinates[kJointCount];
  Frame frames[kJointCount];
  JointCoordinate values[VARIABLES];
  Frame turned;
  for (int period = 0; period <= PERIODS; period += 8) {
    values_at(0, period, values);
    tell(to, set_coordinates(cell_arm::robot, values, coordinates));
    set_frames(cell_arm::robot, coordinates, frames);
    tell_words(to, coordinates, kJointCount);
    tell_words(to, frames, sizeof frames / 4);
    tell(to,
         set_frame(cell_arm::robot, UnitQuaternion{0.8f, 0, 0.6f, 0}, {0.1f, -0.2f, 0.3f}, turned));
    turned = composed(turned, frames[3]);
    tell_words(to, &turned, sizeof turned / 4);
    const Pose pose = relative_pose(frames[0], turned);
    tell(to, pose.status());
    for (int i = 0; i < 9; ++i) {
      tell(to, static_cast<uint32_t>(pose.rotation(i / 3, i % 3)));
    }
    for (int i = 0; i < 3; ++i) {
      tell(to, static_cast<uint32_t>(pose.translation(i)));
    }
  }
  tell(to, static_cast<uint32_t>(angle_coordinate(-2.5f)));
  tell(to, static_cast<uint32_t>(slide_coordinate(0.25f, cell_arm::kCellsPerUnit)));
}

void guard_in_cpp(int motion, story* to) {
  JointCoordinate values[VARIABLES];
  Guard guard(cell_arm::robot, state);
  values_at(motion, 0, values);
  GuardAnswer answer = guard.prime(values);
  tell_of(to, answer);
  for (int period = 1; period <= PERIODS; ++period) {
    answer = tell_period(guard, motion, period, to);
  }
  tell_of(to, guard, answer.pair);
}

void resume_in_cpp(const void* bytes, uint32_t size, story* to) {
  JointCoordinate values[VARIABLES];
  Guard guard(cell_arm::robot, state);
  memcpy(static_cast<void*>(&state), bytes, size < sizeof state ? size : sizeof state);
  tell(to, guard.resume());
  values_at(MOTIONS - 1, PERIODS - 1, values);
  tell_of(to, guard.update(values, GUARD_WORK));
}

void workcell_in_cpp(int motion, story* to) {
  using Memory = WorkcellOf<ROOM_JOINTS, ROOM_LINKS, ROOM_PAIRS, ROOM_REACHES>;
  using State = GuardStateOf<ROOM_JOINTS, ROOM_PAIRS, ROOM_PAIR_JOINTS>;
  auto& memory = in_scratch<Memory>(0);
  auto& crowded = in_scratch<State>(CELL_WORDS);
  static_assert(sizeof(Memory) == 8 * CELL_WORDS && sizeof(State) == CROWDED_BYTES, "as in C");
  JointCoordinate values[VARIABLES];
  Mount ball_at = {kBase, kIdentityFrame};
  uint8_t tool = 0;
  uint8_t ball = 0;
  Workcell cell(cell_arm::robot, memory);
  const PostMesh* const meshes = cell_arm::robot.meshes;
  tell(to, Status::done);
  tell(to, cell.add(meshes[cell_arm::links::gripper], cell_arm::mounts::gripper, tool));
  tell(to, put_ball(0, ball_at.frame));
  tell(to, cell.add(meshes[cell_arm::links::turret], ball_at, ball));
  for (uint8_t link = cell_arm::links::upper_arm; link <= tool; ++link) {
    tell(to, cell.keep_apart(link, ball, STOP_FINE, WARN_FINE));
  }
  tell(to, cell.keep_apart(cell_arm::links::base, tool, 0, WARN_FINE));
  tell(to, cell.robot().hash);
  tell(to, cell.robot().slack);
  Guard guard(cell.robot(), crowded);
  tell(to, Status::done);
  values_at(motion, 0, values);
  tell_of(to, guard.prime(values));
  for (int period = 1; period <= PERIODS; ++period) {
    tell(to, put_ball(period, ball_at.frame));
    tell(to, cell.move(ball, ball_at.frame, BALL_MOVED));
    const GuardAnswer answer = tell_period(guard, motion, period, to);
    if (period % 8 == 0 && answer.pair != kNoPair) {
      tell_of(to, guard, answer.pair);
    }
  }
}

void motion_in_cpp(int motion, story* to) {
  using State = MotionStateOf<VARIABLES, kJointCount>;
  static_assert(sizeof(State) == FLASHBVH_MOTION_STATE_SIZE(VARIABLES, kJointCount), "as in C");
  auto& memory = in_scratch<State>(0);
  JointCoordinate from[VARIABLES];
  JointCoordinate at[VARIABLES];
  values_at(motion, 0, from);
  values_at(motion, PERIODS, at);
  MotionQuery query(cell_arm::robot, memory);
  tell(to, Status::done);
  tell(to, query.start(from, at));
  for (bool goes_on = true; goes_on;) {
    const MotionAnswer a = query.run(MOTION_WORK);
    tell_motion(to, a);
    goes_on = a.status == Status::suspended;
    query.set_values(a.numerator, a.level, at);
  }
  tell_words(to, at, VARIABLES);
}
