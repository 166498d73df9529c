// Queries of a page of a robot: the firmware's. Values are radians and metres in doubles.
#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/kinematics.hpp"
#include "library.hpp"

namespace page {

using namespace flashbvh;

namespace {

constexpr double kFrameCells = 1 << kFrameBits;  // of a frame's translation
constexpr int32_t kOne = 1 << 30;                // of a rotation

/// A guard's answer.
struct Answered {
  uint32_t verdict;
  uint32_t links[2];  ///< of its pair; UINT32_MAX without one
  uint32_t distance;  ///< in 1/256 cell
};

/// The smallest distance of all guarded pairs, and the nearest points.
struct Nearest {
  double distance;  ///< metres
  double points[6];
  uint32_t links[2];
};

Robot robot;
JointCoordinate* values;
JointCoordinate* coordinates;
Frame* frames;
Witness<uint16_t>* hints;
void* state;
size_t state_size;
Answered answered;
Nearest nearest;
double matrix[16];

/// A joint's frame; the base's for kBase.
Frame frame_of_joint(uint32_t joint) {
  return joint != kBase ? frames[joint]
                        : Frame{{{kOne, 0, 0}, {0, kOne, 0}, {0, 0, kOne}}, {0, 0, 0}};
}

Frame frame_of(uint32_t link) {
  return frame_of_joint(robot.links[link].joint);
}

/// The first joint that a value moves directly.
uint32_t joint_of(uint32_t variable) {
  uint32_t joint = 0;
  while (robot.joints[joint].variable != variable || robot.joints[joint].shift != 0 ||
         robot.joints[joint].type == JointType::fixed) {
    ++joint;
  }
  return joint;
}

bool slides(uint32_t variable) {
  return robot.joints[joint_of(variable)].type == JointType::prismatic;
}

/// The unit of a coordinate, in radians or metres.
double unit_of(uint32_t variable) {
  constexpr double kTurn = 6.283185307179586;
  return slides(variable) ? cell() / kFrameCells : kTurn / kFullTurn;
}

struct Ends {
  JointCoordinate lower;
  JointCoordinate upper;
};

/// The coordinates between which a value lies; half a turn each way for a joint without limits.
Ends ends_of(uint32_t variable) {
  const RobotJoint& joint = robot.joints[joint_of(variable)];
  return joint.type == JointType::continuous ? Ends{-kFullTurn / 2, kFullTurn / 2}
                                             : Ends{joint.lower, joint.upper};
}

/// Converts a point of A's frame to the base's.
void set_point(const Frame& frame, const FinePoint& point, double* out) {
  const double p[3] = {point.x / kFineCells, point.y / kFineCells, point.z / kFineCells};
  for (int i = 0; i < 3; ++i) {
    const int32_t(&row)[3] = frame.rotation[i];
    out[i] = cell() * ((row[0] * p[0] + row[1] * p[1] + row[2] * p[2]) / kOne +
                       frame.translation[i] / kFrameCells);
  }
}

/// The matrix, column by column, from cells of a frame, relative to `origin`, to the base's frame
/// in metres.
const double* matrix_from(const Frame& frame, const int32_t (&origin)[3]) {
  for (int i = 0; i < 3; ++i) {
    double at = frame.translation[i] / kFrameCells;
    for (int j = 0; j < 3; ++j) {
      const double entry = static_cast<double>(frame.rotation[i][j]) / kOne;
      matrix[4 * j + i] = entry * cell();
      at += entry * origin[j];
    }
    matrix[12 + i] = at * cell();
  }
  matrix[15] = 1;
  return matrix;
}

}  // namespace

/// Opens the image in the allocated memory; returns a Status.
EXPORT uint32_t open_as_robot(uint32_t bytes) {
  const Status status = open_robot(room_taken, bytes, meshes, kMostMeshes, robot);
  if (status != Status::done) {
    return static_cast<uint32_t>(status);
  }
  hints = take<Witness<uint16_t>>(robot.pair_count);
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    hints[i] = {};
  }
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
EXPORT const char* variable_name(uint32_t variable) {
  return joint_name(room_taken, joint_of(variable));
}
EXPORT const char* name_of_link(uint32_t link) {
  return link_name(room_taken, link);
}
EXPORT bool is_slide(uint32_t variable) {
  return slides(variable);
}
EXPORT double lower(uint32_t variable) {
  return unit_of(variable) * ends_of(variable).lower;
}
EXPORT double upper(uint32_t variable) {
  return unit_of(variable) * ends_of(variable).upper;
}

/// The last variable that moves a link, or kNoVariable.
EXPORT uint32_t variable_of_link(uint32_t link) {
  uint32_t joint = robot.links[link].joint;
  while (joint != kBase && robot.joints[joint].type == JointType::fixed) {
    joint = robot.joints[joint].parent;
  }
  return joint == kBase ? kNoVariable : robot.joints[joint].variable;
}

/// Sets a value, within its limits, in the firmware's units, which it returns.
EXPORT int32_t set_value(uint32_t variable, double value) {
  const double steps = value / unit_of(variable);
  const auto coordinate = static_cast<JointCoordinate>(steps + (steps < 0 ? -0.5 : 0.5));
  const auto [lower, upper] = ends_of(variable);
  return values[variable] = coordinate < lower ? lower : coordinate > upper ? upper : coordinate;
}
EXPORT void set_coordinate(uint32_t variable, int32_t coordinate) {
  values[variable] = coordinate;
}

/// The verdict of a guard that comes from afar: it stops where another one, that starts there,
/// would be leaving.
EXPORT const void* verdict() {
  Guard guard(robot, state, state_size);
  const GuardAnswer answer = guard.prime(values);
  const bool has_pair = answer.pair != kNoPair;
  const Verdict verdict = answer.verdict == Verdict::leaving ? Verdict::stop : answer.verdict;
  answered = {static_cast<uint32_t>(verdict),
              {has_pair ? robot.pairs[answer.pair].a : UINT32_MAX,
               has_pair ? robot.pairs[answer.pair].b : UINT32_MAX},
              answer.distance};
  return &answered;
}

/// Updates the links' frames from the values.
EXPORT void place_links() {
  if (set_coordinates(robot, values, coordinates) == Status::done) {
    set_frames(robot, coordinates, frames);
  }
}
/// From a link's vertices to the base's frame.
EXPORT const double* matrix_of(uint32_t link) {
  return matrix_from(frame_of(link), meshes[link].origin);
}
/// From cells of a joint's frame.
EXPORT const double* matrix_of_joint(uint32_t joint) {
  return matrix_from(frame_of_joint(joint), {0, 0, 0});
}

/// Measures all guarded pairs of links before `end`, after which are parts of neighbours outside
/// their zones, each with its last nearest pair as a hint; null if there is no distance.
EXPORT const void* nearest_links(uint32_t end) {
  constexpr double kFar = 1e300;
  nearest.distance = kFar;
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    const uint32_t a = robot.pairs[i].a;
    const uint32_t b = robot.pairs[i].b;
    if (a >= end || b >= end) {
      continue;
    }
    const Frame frame = frame_of(a);
    const auto found = distance(meshes[a], meshes[b], relative_pose(frame, frame_of(b)), hints[i]);
    if (found.status != Status::done || !found.in_range) {
      continue;
    }
    hints[i] = found.witness;
    const double metres = found.lower / kFineCells * cell();
    if (metres < nearest.distance) {
      nearest = {metres, {}, {a, b}};
      set_point(frame, found.point_a, nearest.points);
      set_point(frame, found.point_b, nearest.points + 3);
    }
  }
  return nearest.distance < kFar ? &nearest : nullptr;
}

}  // namespace page
