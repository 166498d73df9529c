// Meshes and robots that nobody opened, and objects that no constructor made, on each core: no
// answer permits anything.
#include <catch2/catch.hpp>

#include <stdint.h>

#include "flashbvh/deformable.hpp"
#include "flashbvh/shape.hpp"
#include "support/arms/refused.hpp"
#include "support/refused.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

// Zeros in .bss, as in firmware that forgets to open them.
Mesh plate;
Mesh peg;
Robot robot;
GuardStateOf<2, 1, 2> guard_state;
MotionStateOf<2, 1> motion_state;
WorkcellOf<2, 2, 2, 2> memory;
JointCoordinate values[kMaxJoints];

}  // namespace

TEST_CASE("no query, ray or shape takes a mesh of zeros") {
  CHECK(are_refused(plate, peg, Status::not_open));
  CHECK(is_refused(plate, Status::not_open, Status::not_open));
  CHECK(PointShape(plate, {1, 2, 3}).status() == Status::not_open);
}

TEST_CASE("an object that no constructor made says not_open") {
  TrianglePair<uint16_t> found[1];
  Zeros<PairQuery> query;
  CHECK(query->run(UINT32_MAX, found).status == Status::not_open);
  Zeros<WithinQuery> near;
  CHECK(near->run(UINT32_MAX, found).status == Status::not_open);
  Zeros<ClearanceQuery> clearance;
  CHECK(clearance->run(UINT32_MAX).status == Status::not_open);
  Zeros<SelfQuery> self;
  CHECK(self->run(UINT32_MAX, found).status == Status::not_open);
  Zeros<DeformableQuery<PairQuery>> bent;
  CHECK(bent->run(UINT32_MAX, found).status == Status::not_open);
  Zeros<DeformableMesh> deformable;
  CHECK(deformable->refit().status == Status::not_open);
  CHECK(are_refused(deformable->mesh(), deformable->mesh(), Status::not_open));
  Zeros<BoxShape> box;
  CHECK(are_refused(box->mesh(), box->mesh(), Status::not_open));
  Zeros<BodyMotion> motion;
  CHECK(motion->status() == Status::not_open);
  CHECK(motion->pose_at(0).status() != Status::done);
  Zeros<FirstContact> contact;
  CHECK(contact->status() == Status::not_open);
  CHECK(contact->run(UINT32_MAX).status == Status::not_open);
  CHECK(contact->resume({}) == Status::not_open);
}

TEST_CASE("no guard, motion or workcell takes a robot of zeros") {
  Guard guard(robot, guard_state);
  check_refused(guard, values);
  MotionQuery motion(robot, motion_state);
  check_refused(motion, values);
  Workcell workcell(robot, memory);
  check_refused(workcell, peg);
}

TEST_CASE("guards, motions and workcells that no constructor made refuse") {
  check_refused(*Zeros<Guard>(), values);
  check_refused(*Zeros<MotionQuery>(), values);
  check_refused(*Zeros<Workcell>(), peg);
}
