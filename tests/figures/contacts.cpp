// Triangles, contacts and poses, each by itself.
#include "costs.hpp"
#include "flashbvh/contact.hpp"
#include "support/points.hpp"
#include "support/rotations.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20240607;
constexpr uint32_t kPairs = 300;

constexpr int32_t kReach = 8000;  // differences below 2^15

/// `adapt` changes a pair of random triangles into one of its kind.
struct TriangleKind {
  const char* name;
  void (*adapt)(Triangle& a, Triangle& b);
};

constexpr TriangleKind kTriangleKinds[] = {{"boxes_disjoint",
                                            [](Triangle&, Triangle& b) {
                                              for (Point& corner : b.corner) {
                                                corner.z += 16001;
                                              }
                                            }},
                                           {"general", [](Triangle&, Triangle&) {}},
                                           {"coplanar",
                                            [](Triangle& a, Triangle& b) {
                                              for (int i = 0; i < 3; ++i) {
                                                a.corner[i].z = a.corner[i].x + a.corner[i].y;
                                                b.corner[i].z = b.corner[i].x + b.corner[i].y;
                                              }
                                            }},
                                           {"segments", [](Triangle& a, Triangle& b) {
                                              a.corner[2] = a.corner[1];
                                              b.corner[2] = b.corner[1];
                                            }}};

void measure_kind(const TriangleKind& kind) {
  test::Random random(kSeed);
  for (uint32_t i = 0; i < kPairs; ++i) {
    Triangle a;
    Triangle b;
    for (int k = 0; k < 3; ++k) {
      a.corner[k] = test::any_point(random, kReach);
      b.corner[k] = test::any_point(random, kReach);
    }
    kind.adapt(a, b);
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
  for (const TriangleKind& kind : kTriangleKinds) {
    measure_kind(kind);
  }
  measure_poses();
  return true;
}

}  // namespace figures
