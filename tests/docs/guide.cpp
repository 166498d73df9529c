// The C++ of the guide: a peg that is about to move above a plate. snippets.py writes the included
// files; only they include the library's headers.
#include "guide_01.cpp"
#include "guide_02.cpp"
#include "guide_04.cpp"
#include "guide_05.cpp"
#include "guide_07.cpp"
#include "guide_08.cpp"
#include "guide_09.cpp"
#include "guide_10.cpp"
#include "guide_11.cpp"
// Uses what stands before it.
#include <initializer_list>

namespace {

/// The peg upright, `height` mm above the plate.
flashbvh::Pose lowered_to(float height) {
  return peg_in_plate(flashbvh::Pose::translated(0, 0, 0), {1, 0, 0, 0}, 0, 0, height);
}

/// The verdict with the peg at this height; on a stop, gets the contact's height.
Verdict verdict_at(float height, float& mm, int64_t& nm) {
  Check check(lowered_to(height));
  Verdict verdict = Verdict::pending;
  while (verdict == Verdict::pending) {
    verdict = check.tick();
  }
  if (check.has_contact()) {
    mm = height_mm(check.contact());
    nm = height_nm(check.contact());
  }
  return verdict;
}

}  // namespace

int main() {
  float mm = 1;
  int64_t nm = 1000000;
  Guard guard;
  for (const float height : {20.0f, 8.0f, 3.0f, 0.5f, 0.0f}) {
    const auto speed = guard.at(lowered_to(height));
    if (speed != (height > 5   ? Guard::Speed::full
                  : height > 1 ? Guard::Speed::slow
                               : Guard::Speed::stop)) {
      return 2;
    }
  }
  if (!is_clear(lowered_to(3), 2.9f) || is_clear(lowered_to(3), 3) ||
      is_clear(lowered_to(3), __builtin_nanf(""))) {
    return 7;
  }
  const auto travels = [](const flashbvh::Pose& from, const flashbvh::Pose& to) {
    Travel travel(from, to);
    Verdict verdict = Verdict::pending;
    while (verdict == Verdict::pending) {
      verdict = travel.tick();
    }
    return verdict == Verdict::no_contact;
  };
  if (!travels(lowered_to(3), lowered_to(0.6f)) || travels(lowered_to(3), lowered_to(0.4f)) ||
      travels(lowered_to(20), lowered_to(-60))) {
    return 8;
  }
  const Cable cable;
  if (!cable.touches_plate(lowered_to(1.9f)) || cable.touches_plate(lowered_to(2.1f))) {
    return 3;
  }
  const float seen = height_seen({30, 20, 12}, 100);
  if (seen < 11.99f || seen > 12.01f || height_seen({30, 20, 12}, 5) != 5 ||
      height_seen({300, 20, 12}, 100) != 100 || height_seen({30, 20, 12}, -1) != 0) {
    return 4;
  }
  SoftPeg soft;
  const bool apart = !soft.touches_plate_or_itself(lowered_to(3));
  for (uint32_t i = 0; i < peg_VERTEX_COUNT; ++i) {
    flashbvh::Vertex& v = soft.vertices()[i];
    v.z = static_cast<int16_t>(v.z < 0 ? 2 * v.z : v.z);
  }
  if (!apart || !soft.touches_plate_or_itself(lowered_to(3))) {
    return 6;
  }
  ArmGuard arm;
  const float upright[] = {0, 0, 0.5f, 0};
  const float folded[] = {0, 0.2f, 2.9f, 1.5f};
  if (!arm.start(upright) || !arm.tick(upright) || arm.start(folded)) {
    return 5;
  }
  flashbvh::PairQuery::Pair by_volume[64];
  if (pairs_by_volume(lowered_to(0), by_volume).count !=
          flashbvh::count_pairs(plate, peg, lowered_to(0)).count ||
      pairs_by_volume(lowered_to(3), by_volume).count != 0) {
    return 9;
  }
  const flashbvh::Mesh& body = arm_robot.meshes[cell_arm_link_gripper];
  flashbvh::Frame cart_at = flashbvh::kIdentityFrame;
  if (!furnish(body, body, cart_at) || !drive(cart_at, {256})) {
    return 6;
  }
  return verdict_at(0.5f, mm, nm) == Verdict::no_contact && mm == 1 &&
                 verdict_at(0, mm, nm) == Verdict::stop && mm > -0.01f && mm < 0.01f &&
                 nm > -10000 && nm < 10000
             ? 0
             : 1;
}
