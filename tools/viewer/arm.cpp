// flashbvh's queries for the page of a robot: the firmware's library, for WebAssembly. Values are
// radians and metres in doubles.
#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "meshes.hpp"

namespace live {

using namespace flashbvh;

namespace {

constexpr uint32_t kMostFine = kMaxGuardDistance;
constexpr double kFrameCells = 1 << kFrameBits;  // of a frame's translation
constexpr double kOne = 1 << 30;                 // of a rotation

/// The smallest distance of all guarded pairs, and the nearest points.
struct Nearest {
  double distance;  ///< metres
  double points[6];
  uint32_t pair;
};

Robot robot;
const RobotPair* baked;
RobotPair* pairs;
JointCoordinate* values;
JointCoordinate* coordinates;
Frame* frames;
Witness<uint16_t>* hints;
void* state;
size_t state_size;
GuardAnswer answer;
Nearest nearest;
double matrix[16];

/// A joint's frame; the base's for kBase.
Frame frame_of_joint(uint32_t joint) {
  if (joint != kBase) {
    return frames[joint];
  }
  constexpr int32_t one = 1 << 30;
  return {{{one, 0, 0}, {0, one, 0}, {0, 0, one}}, {0, 0, 0}};
}

Frame frame_of(uint32_t link) {
  return frame_of_joint(robot.links[link].joint);
}

/// The first joint that a value moves directly.
const RobotJoint& joint_of(uint32_t variable) {
  return robot.joints[wasm::joint_of(robot, variable)];
}

bool slides(uint32_t variable) {
  return joint_of(variable).type == JointType::prismatic;
}

/// The unit of a coordinate, in radians or metres.
double unit_of(uint32_t variable) {
  constexpr double kTurn = 6.283185307179586;
  return slides(variable) ? cell() / kFrameCells : kTurn / kFullTurn;
}

/// Converts a point of A's frame to the base's.
void set_point(const Frame& frame, const FinePoint& point, double* out) {
  const double p[3] = {point.x / kFineCells, point.y / kFineCells, point.z / kFineCells};
  for (int i = 0; i < 3; ++i) {
    const int32_t(&row)[3] = frame.rotation[i];
    out[i] = cell() * (row[0] / kOne * p[0] + row[1] / kOne * p[1] + row[2] / kOne * p[2] +
                       frame.translation[i] / kFrameCells);
  }
}

/// Sets the matrix from cells of a frame, relative to `origin`, to the base.
void set_matrix(const Frame& frame, const int32_t (&origin)[3]) {
  for (int i = 0; i < 3; ++i) {
    double at = frame.translation[i] / kFrameCells;
    for (int j = 0; j < 3; ++j) {
      matrix[4 * j + i] = frame.rotation[i][j] / kOne * cell();
      at += frame.rotation[i][j] / kOne * origin[j];
    }
    matrix[12 + i] = at * cell();
    matrix[4 * i + 3] = 0;
  }
  matrix[15] = 1;
}

}  // namespace

/// Opens the image in the allocated memory; returns a Status.
EXPORT uint32_t open(uint32_t bytes) {
  const Status status = open_robot(room_taken, bytes, meshes, kMostMeshes, robot);
  if (status != Status::done) {
    return static_cast<uint32_t>(status);
  }
  pairs = take<RobotPair>(robot.pair_count);
  hints = take<Witness<uint16_t>>(robot.pair_count);
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    pairs[i] = robot.pairs[i];
    hints[i] = {};
  }
  baked = robot.pairs;
  robot.pairs = pairs;
  values = take<JointCoordinate>(robot.variable_count);
  coordinates = take<JointCoordinate>(robot.joint_count);
  frames = take<Frame>(robot.joint_count);
  const auto* const header = static_cast<const RobotImageHeader*>(room_taken);
  state_size =
      FLASHBVH_GUARD_STATE_SIZE(robot.joint_count, robot.pair_count, header->pair_joint_count);
  state = take(state_size);
  return 0;
}

EXPORT uint32_t variable_count() {
  return robot.variable_count;
}
EXPORT uint32_t link_count() {
  return robot.link_count;
}
EXPORT uint32_t pair_count() {
  return robot.pair_count;
}
EXPORT const char* variable_name(uint32_t variable) {
  return joint_name(room_taken, wasm::joint_of(robot, variable));
}
EXPORT const char* name_of_link(uint32_t link) {
  return link_name(room_taken, link);
}
EXPORT bool is_slide(uint32_t variable) {
  return slides(variable);
}
/// A joint without limits gets half a turn in each direction.
EXPORT double lower(uint32_t variable) {
  const RobotJoint& joint = joint_of(variable);
  return unit_of(variable) * (joint.type == JointType::continuous ? -kFullTurn / 2 : joint.lower);
}
EXPORT double upper(uint32_t variable) {
  const RobotJoint& joint = joint_of(variable);
  return unit_of(variable) * (joint.type == JointType::continuous ? kFullTurn / 2 : joint.upper);
}
EXPORT uint32_t first_of_pair(uint32_t pair) {
  return pairs[pair].a;
}
EXPORT uint32_t second_of_pair(uint32_t pair) {
  return pairs[pair].b;
}
EXPORT double stop_of(uint32_t pair) {
  return pairs[pair].stop / kFineCells * cell();
}
EXPORT double warn_of(uint32_t pair) {
  return pairs[pair].warn / kFineCells * cell();
}

/// Sets the distances of all pairs, in metres. Pairs baked with less than the longest distance are
/// always near each other; they keep their distances unless the new ones are shorter.
EXPORT void set_distances(double stop, double warn) {
  const auto fine = [](double metres) {
    const uint32_t steps = live::fine_length_rounded_up(metres).count;
    return steps < kMostFine ? steps : kMostFine;
  };
  const auto longest = [](uint32_t RobotPair::*distance) {
    uint32_t most = 0;
    for (uint32_t i = 0; i < robot.pair_count; ++i) {
      most = baked[i].*distance > most ? baked[i].*distance : most;
    }
    return most;
  };
  const auto set = [&](uint32_t RobotPair::*distance, uint32_t given) {
    const uint32_t most = longest(distance);
    for (uint32_t i = 0; i < robot.pair_count; ++i) {
      const uint32_t own = baked[i].*distance;
      pairs[i].*distance = own < most && own < given ? own : given;
    }
  };
  set(&RobotPair::stop, fine(stop));
  set(&RobotPair::warn, fine(warn < stop ? stop : warn));
}

/// The last variable that moves a link, or kNoVariable.
EXPORT uint32_t variable_of_link(uint32_t link) {
  for (uint32_t joint = robot.links[link].joint; joint != kBase;
       joint = robot.joints[joint].parent) {
    if (robot.joints[joint].type != JointType::fixed) {
      return robot.joints[joint].variable;
    }
  }
  return kNoVariable;
}

/// Sets a value and clamps it to its limits.
EXPORT void set_value(uint32_t variable, double value) {
  const double steps = value / unit_of(variable);
  const RobotJoint& joint = joint_of(variable);
  auto coordinate = static_cast<JointCoordinate>(steps + (steps < 0 ? -0.5 : 0.5));
  if (joint.type != JointType::continuous) {
    coordinate = coordinate < joint.lower ? joint.lower : coordinate;
    coordinate = coordinate > joint.upper ? joint.upper : coordinate;
  }
  values[variable] = coordinate;
}
/// The value in firmware's units.
EXPORT int32_t coordinate_of(uint32_t variable) {
  return values[variable];
}
EXPORT void set_coordinate(uint32_t variable, int32_t coordinate) {
  values[variable] = coordinate;
}

/// Updates the links' frames from the values.
EXPORT void place() {
  if (set_coordinates(robot, values, coordinates) == Status::done) {
    set_frames(robot, coordinates, frames);
  }
}

/// The Verdict of a guard without previous knowledge.
EXPORT uint32_t verdict() {
  Guard guard(robot, state, state_size);
  answer = guard.prime(values);
  return static_cast<uint32_t>(answer.verdict);
}
/// The pair of the last verdict.
EXPORT uint32_t pair_of_answer() {
  return answer.pair;
}
EXPORT uint32_t distance_of_answer() {
  return answer.distance;
}

/// A matrix, column by column, from a link's vertices to the base's frame, in metres.
EXPORT const double* matrix_of(uint32_t link) {
  set_matrix(frame_of(link), meshes[link].origin);
  return matrix;
}
/// A matrix like matrix_of(), from cells of a joint's frame.
EXPORT const double* matrix_of_joint(uint32_t joint) {
  constexpr int32_t kNone[3] = {};
  set_matrix(frame_of_joint(joint), kNone);
  return matrix;
}

/// Measures all guarded pairs, each with its last nearest pair as a hint. Returns the smallest
/// distance, two points in the base's frame and the pair; null if there is none.
EXPORT const Nearest* measure() {
  nearest = {1e300, {}, kNoPair};
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    const uint32_t a = pairs[i].a;
    const uint32_t b = pairs[i].b;
    const Frame frame = frame_of(a);
    const auto found = distance(meshes[a], meshes[b], relative_pose(frame, frame_of(b)), hints[i]);
    if (found.status != Status::done || !found.in_range) {
      continue;
    }
    hints[i] = found.witness;
    const double metres = found.lower / kFineCells * cell();
    if (metres < nearest.distance) {
      nearest.distance = metres;
      nearest.pair = i;
      set_point(frame, found.point_a, nearest.points);
      set_point(frame, found.point_b, nearest.points + 3);
    }
  }
  return nearest.pair == kNoPair ? nullptr : &nearest;
}

}  // namespace live
