// Mesh and poses of the known-answer tests of meshes.
#ifndef FLASHBVH_SELF_TEST_KNOWN_ANSWERS_HPP
#define FLASHBVH_SELF_TEST_KNOWN_ANSWERS_HPP

#include <stdint.h>

#include "answer_digest.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/pose.hpp"
#include "known_mesh.hpp"

namespace flashbvh::detail {

inline Mesh known_mesh() {
  return view_unchecked<Mesh>(kKnownMesh);
}

/// Visits four translations, then eight rigid poses. With `apart` = 1, two of the translations let
/// one vertex touch another. Each rigid pose is the previous one, turned about an axis off the
/// origin. `apart`: factor of all translations.
template <class Visit>
void for_each_known_pose(int32_t apart, Visit&& visit) {
  constexpr int16_t translations[4][3] = {
      {0, 1611, 2066}, {-4781, 0, -1038}, {300, -1500, 1100}, {-100, 60, 20}};
  for (const int16_t(&by)[3] : translations) {
    visit(Pose::translated(by[0] * apart, by[1] * apart, by[2] * apart));
  }
  constexpr int32_t rotation[3][3] = {{435771147, -850914073, -488845837},
                                      {421159491, 645276505, -747772973},
                                      {886368826, 111736191, 595639851}};
  const int32_t cells[3] = {900 * apart, -500 * apart, -1149 * apart};
  constexpr int16_t fraction[3] = {12345, -23456, 31000};
  const Pose turn = Pose::rigid(rotation, cells, fraction);
  Pose pose = turn;
  for (int i = 0; i < 8; ++i) {
    visit(pose);
    pose = Pose::composed(turn, pose);
  }
}

/// Digests of the known-answer tests in self_test.hpp.
uint32_t known_pairs_digest();
uint32_t known_distances_digest();
uint32_t known_rays_digest();

}  // namespace flashbvh::detail

#endif
