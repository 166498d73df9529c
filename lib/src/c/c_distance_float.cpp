// The C interface to distances as floats: apart, for firmware that has none.
#include "flashbvh/clearance.h"
#include "flashbvh/pose_float.hpp"
#include "objects.hpp"

using namespace flashbvh;

uint32_t flashbvh_fine_distance(float length, float cells_per_unit) {
  return fine_distance(length, cells_per_unit);
}

float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh) {
  return length_in_unit(fine, object_in(mesh).cell_bits);
}
