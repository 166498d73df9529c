// Triangles, contacts and poses, each by itself.
#include "costs.hpp"
#include "flashbvh/contact.hpp"
#include "support/rotations.hpp"
#include "support/triangle_kinds.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20240607;
constexpr uint32_t kPairs = 300;

void measure_kind(const test::TriangleKind& kind) {
  test::Random random(kSeed);
  for (uint32_t i = 0; i < kPairs; ++i) {
    Triangle a;
    Triangle b;
    test::set_random_pair(random, kind, a, b);
    bool yes = false;
    measure({{"part", "triangles", kind.name}}, [&] { yes = detail::triangles_intersect(a, b); });
    add_to_digest(yes ? 1 : 0);
    if (yes) {
      Contact contact;
      measure({{"part", "contact", kind.name}}, [&] { contact = contact_of(a, b); });
      add_to_digest(static_cast<uint32_t>(contact.kind));
    }
  }
}

void measure_poses() {
  test::Random random(kSeed);
  for (uint32_t i = 0; i < kPairs; ++i) {
    const test::Rotation rotation = test::rotation_of(test::any_quaternion(random));
    const int32_t cells[3] = {1000, -2000, 3000};
    Pose pose = Pose::translated(0, 0, 0);
    measure({{"part", "pose", "rigid"}}, [&] { pose = Pose::rigid(rotation.entry, cells); });
    const Pose other = Pose::rigid(test::rotation_of(test::any_quaternion(random)).entry, cells);
    measure({{"part", "pose", "relative"}}, [&] { pose = Pose::relative(other, pose); });
  }
}

}  // namespace

bool measure_contacts() {
  for (const test::TriangleKind& kind : test::kTriangleKinds) {
    measure_kind(kind);
  }
  measure_poses();
  return true;
}

}  // namespace figures
