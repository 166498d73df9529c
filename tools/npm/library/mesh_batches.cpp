// The C interface to meshes in batches, for meshes.js: one call for many poses, rays or points. A
// call returns the number of answers: `count`, or on an error the number of the first failed query,
// whose status is last_status().
#include "../../wasm.hpp"
#include "flashbvh/clearance.h"
#include "flashbvh/ray.h"
#include "flashbvh/solid.h"

namespace batches {
namespace {

flashbvh_status last;

/// Calls query(i) until one fails.
template <class Query>
uint32_t for_each(uint32_t count, const Query& query) {
  last = FLASHBVH_STATUS_DONE;
  for (uint32_t i = 0; i < count; ++i) {
    last = query(i);
    if (last != FLASHBVH_STATUS_DONE) {
      return i;
    }
  }
  return count;
}

/// Writes a point in 1/256 cell: a double represents the whole range exactly.
void put(const flashbvh_fine_point& point, double* to) {
  to[0] = static_cast<double>(point.x);
  to[1] = static_cast<double>(point.y);
  to[2] = static_cast<double>(point.z);
}

}  // namespace

EXPORT flashbvh_status last_status() {
  return last;
}

/// The sizes of a mesh and of a pose in bytes.
EXPORT const uint32_t* sizes() {
  static const uint32_t bytes[] = {sizeof(flashbvh_mesh), sizeof(flashbvh_pose)};
  return bytes;
}

/// The cell in the mesh's unit.
EXPORT double cell(const flashbvh_mesh* mesh) {
  return wasm::length_of(flashbvh_mesh_cell(mesh));
}

/// Twelve numbers per pose: a rotation row by row, then a translation in the unit.
EXPORT uint32_t poses_of_matrices(const flashbvh_mesh* mesh, uint32_t count, const float* numbers,
                                  flashbvh_pose* poses) {
  const float cells = flashbvh_mesh_cells_per_unit(mesh);
  return for_each(count, [&](uint32_t i) {
    const float* const pose = numbers + 12 * i;
    return flashbvh_pose_of_matrix(pose, pose + 9, cells, poses + i);
  });
}

/// Seven numbers per pose: w, x, y, z, then a translation in the unit.
EXPORT uint32_t poses_of_quaternions(const flashbvh_mesh* mesh, uint32_t count,
                                     const float* numbers, flashbvh_pose* poses) {
  const float cells = flashbvh_mesh_cells_per_unit(mesh);
  return for_each(count, [&](uint32_t i) {
    return flashbvh_pose_of_quaternion(numbers + 7 * i, numbers + 7 * i + 4, cells, poses + i);
  });
}

EXPORT uint32_t solids_intersect(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                 const flashbvh_pose* poses, uint32_t count, bool* yes) {
  return for_each(count,
                  [&](uint32_t i) { return flashbvh_solids_intersect(a, b, poses + i, yes + i); });
}

/// `distance` is in 1/256 cell.
EXPORT uint32_t closer_than(const flashbvh_mesh* a, const flashbvh_mesh* b,
                            const flashbvh_pose* poses, uint32_t count, uint32_t distance,
                            bool* yes) {
  return for_each(
      count, [&](uint32_t i) { return flashbvh_closer_than(a, b, poses + i, {distance}, yes + i); });
}

EXPORT uint32_t first_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                            const flashbvh_pose* poses, uint32_t count, bool* yes,
                            flashbvh_pair* triangles) {
  return for_each(count, [&](uint32_t i) {
    triangles[i] = {0, 0};
    return flashbvh_first_pair(a, b, poses + i, yes + i, triangles + i);
  });
}

/// `is_motion`: each pose's nearest pair is the hint of the next pose.
EXPORT uint32_t distances(const flashbvh_mesh* a, const flashbvh_mesh* b,
                          const flashbvh_pose* poses, uint32_t count, bool is_motion,
                          uint32_t* lower, uint32_t* upper, double* points_a, double* points_b,
                          flashbvh_pair* triangles, bool* in_range) {
  flashbvh_witness hint = FLASHBVH_NO_WITNESS;
  return for_each(count, [&](uint32_t i) {
    flashbvh_clearance found;
    const flashbvh_status status = flashbvh_distance(a, b, poses + i, &hint, &found);
    lower[i] = found.lower;
    upper[i] = found.upper;
    put(found.point_a, points_a + 3 * i);
    put(found.point_b, points_b + 3 * i);
    triangles[i] = found.triangles;
    in_range[i] = found.in_range;
    if (is_motion && found.in_range) {
      hint = found.witness;
    }
    return status;
  });
}

/// Seven numbers per ray, in the unit: an origin, a direction and a reach.
EXPORT uint32_t nearest_hits(const flashbvh_mesh* mesh, uint32_t count, const float* rays,
                             bool* yes, uint16_t* triangles, int8_t* sides, uint32_t* distances,
                             double* points) {
  const float cells = flashbvh_mesh_cells_per_unit(mesh);
  return for_each(count, [&](uint32_t i) {
    const float* const ray = rays + 7 * i;
    flashbvh_segment segment;
    flashbvh_hit hit{};
    flashbvh_status status = flashbvh_segment_of(ray, ray + 3, ray[6], cells, &segment);
    if (status == FLASHBVH_STATUS_DONE) {
      status = flashbvh_nearest_hit(mesh, &segment, FLASHBVH_NO_HINT, yes + i, &hit);
    }
    if (status == FLASHBVH_STATUS_DONE && yes[i]) {
      flashbvh_fine_point point;
      flashbvh_point_along(&segment, &hit, &point);
      put(point, points + 3 * i);
      triangles[i] = hit.triangle;
      sides[i] = hit.side;
      distances[i] = flashbvh_distance_along(&segment, &hit);
    }
    return status;
  });
}

/// `points` are in cells.
EXPORT uint32_t inside(const flashbvh_mesh* mesh, uint32_t count, const flashbvh_point* points,
                       uint8_t* sides) {
  return for_each(count, [&](uint32_t i) {
    flashbvh_point_side side = FLASHBVH_POINT_INSIDE;
    const flashbvh_status status = flashbvh_inside(mesh, points + i, &side);
    sides[i] = static_cast<uint8_t>(side);
    return status;
  });
}

}  // namespace batches
