// Queries of a page of meshes: the firmware's.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/solid.hpp"
#include "library.hpp"

namespace page {

using namespace flashbvh;

namespace {

constexpr uint32_t kMostLit = 1000;
constexpr uint32_t kMostCounted = 100000;
constexpr uint32_t kMostWayWork = 1000000;  // about a tenth of a second

/// Rows of the rotation in 2^-30, then cells and 1/65,536 of cells.
struct PoseWords {
  int32_t rotation[3][3];
  int32_t cells[3];
  int32_t fraction[3];
};

/// Two intersecting triangles, relative to A's origin.
struct Lit {
  Triangle a;
  Triangle b;
};

/// The answers for B at the pose. Points are in cells of A's frame.
struct Measured {
  uint32_t status;    ///< of the first refused query; all other fields are then undefined
  uint32_t pairs;     ///< number of intersecting triangle pairs, at most kMostCounted
  uint32_t inside;    ///< without such a pair: 1 if one mesh is inside the other, 2 if not tested
  uint32_t in_range;  ///< if 0, there are no triangles or points
  uint32_t lower;     ///< lower bound of the distance, in 1/256 cell
  uint32_t triangles[2];
  double points[2][3];
};

/// B's straight motion from the last pose to the pose. Times are in 2^-30 of it.
struct Way {
  uint32_t status;   ///< `suspended`: the query took too long
  uint32_t outcome;  ///< a ContactOutcome
  uint32_t to;
};

PoseWords words;
Pose pose = Pose::translated(0, 0, 0);
Pose pose_before = Pose::translated(0, 0, 0);
Way way;
Lit lit[kMostLit];
Measured measured;
Witness<uint16_t> hint;

uint32_t code(Status status) {
  return static_cast<uint32_t>(status);
}

void set_cells(const FinePoint& point, double (&cells)[3]) {
  cells[0] = static_cast<double>(point.x) / kFineCells;
  cells[1] = static_cast<double>(point.y) / kFineCells;
  cells[2] = static_cast<double>(point.z) / kFineCells;
}

}  // namespace

/// Opens the last allocated image as mesh number `mesh`; returns a Status.
EXPORT uint32_t open_as_mesh(uint32_t mesh, uint32_t bytes) {
  return code(open_image(room_taken, bytes, meshes[mesh]));
}
EXPORT const void* origin(uint32_t mesh) {
  return meshes[mesh].origin;
}
EXPORT double cell_size(uint32_t mesh) {
  return cell(mesh);
}

/// The memory for a pose; place() then sets it and returns a Status.
EXPORT void* pose_words() {
  return &words;
}
EXPORT uint32_t place() {
  const int16_t fraction[3] = {static_cast<int16_t>(words.fraction[0]),
                               static_cast<int16_t>(words.fraction[1]),
                               static_cast<int16_t>(words.fraction[2])};
  pose_before = pose;
  pose = Pose::rigid(words.rotation, words.cells, fraction);
  return code(pose.status());
}

/// The first intersecting triangles of the last measure().
EXPORT const void* lit_triangles() {
  return lit;
}
/// Starts with the last nearest pair as a hint if the meshes are the same.
EXPORT const void* measure(uint32_t a, uint32_t b) {
  static uint32_t before[2] = {UINT32_MAX, UINT32_MAX};
  if (before[0] != a || before[1] != b) {
    before[0] = a;
    before[1] = b;
    hint = {};
  }
  measured = {};
  DefaultQuery<uint16_t> query(meshes[a], meshes[b], pose);
  const RunResult run = query.run(UINT32_MAX, [&](const TrianglePair<uint16_t>&) {
    if (measured.pairs < kMostLit) {
      Lit& found = lit[measured.pairs];
      query.last_pair(found.a, found.b);
    }
    return ++measured.pairs < kMostCounted;
  });
  const auto found = distance(meshes[a], meshes[b], pose, hint);
  if ((run.status != Status::done && run.status != Status::full) || found.status != Status::done) {
    measured.status = code(found.status == Status::done ? run.status : found.status);
    return &measured;
  }
  if (measured.pairs == 0) {
    const bool are_closed = meshes[a].is_closed && meshes[b].is_closed;
    measured.inside = !are_closed ? 2 : one_is_inside(meshes[a], meshes[b], pose).yes ? 1 : 0;
  }
  measured.lower = found.lower;
  measured.in_range = found.in_range;
  if (found.in_range) {
    hint = found.witness;
    measured.triangles[0] = found.triangles.a;
    measured.triangles[1] = found.triangles.b;
    set_cells(found.point_a, measured.points[0]);
    set_cells(found.point_b, measured.points[1]);
  }
  return &measured;
}

/// Certifies the motion between the last two poses.
EXPORT const void* certify(uint32_t a, uint32_t b) {
  const BodyMotion motion = BodyMotion::between(pose_before, pose);
  FirstContact query(meshes[a], meshes[b], motion);
  const FirstContactAnswer found = query.run(kMostWayWork);
  way = {code(found.status), static_cast<uint32_t>(found.outcome), found.to};
  return &way;
}

}  // namespace page
