// The C++ of the guide and of the README: a peg that is about to move above a plate.
#include <flashbvh/flashbvh.hpp>
#include <flashbvh/float.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/robot/guard.hpp>
#include <flashbvh/robot/image.hpp>
#include <flashbvh/robot/robot_float.hpp>
#include <flashbvh/robot/workcell.hpp>
#include <initializer_list>

#include "cell_arm.robot.h"
#include "peg.fbvh.h"
#include "plate.fbvh.h"

namespace {

const auto plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
const auto peg = flashbvh::view_unchecked<flashbvh::Mesh>(peg_image);

/// At most 84,000 cycles a slice: 1 kHz, 168 MHz, half of the period.
constexpr uint32_t kWork =
    flashbvh::work_within(84000, flashbvh::kCortexM4FCycles, 0, plate_TREE_SIZE, peg_TREE_SIZE);
static_assert(kWork != 0, "the period is too short for a single step");
static_assert(plate_IMAGE_BYTES + peg_IMAGE_BYTES < 4096, "the meshes' share of flash");

flashbvh::Pose peg_in_plate(const flashbvh::Pose& plate_in_world, const flashbvh::UnitQuaternion& q,
                            float x, float y, float z) {
  const flashbvh::Pose peg_in_world = flashbvh::pose_of(q, {x, y, z}, plate_CELLS_PER_UNIT);
  return flashbvh::Pose::relative(plate_in_world, peg_in_world);
}

// The README's examples.

/// May the peg go there? Exact, for the two solids; an error is no permission to move on.
bool may_go(const flashbvh::Pose& peg_in_plate) {
  return !flashbvh::solids_intersect(plate, peg, peg_in_plate).yes;
}

/// Is it nearer than that, in mm? After an error, too.
bool is_near(const flashbvh::Pose& peg_in_plate, float length) {
  const uint32_t within = flashbvh::fine_distance(length, plate_CELLS_PER_UNIT);
  return flashbvh::closer_than(plate, peg, peg_in_plate, within).yes;
}

/// Is no point of the peg's file nearer to the plate's than that, in mm? After an error it is.
bool is_clear(const flashbvh::Pose& peg_in_plate, float length) {
  constexpr uint32_t kPlacing = 228;  // 0.51 cells along each axis, in 1/256 cell
  const uint32_t within = flashbvh::fine_distance(length, plate_CELLS_PER_UNIT) +
                          plate_DEVIATION_FINE + peg_DEVIATION_FINE + kPlacing;
  return !flashbvh::closer_than(plate, peg, peg_in_plate, within).yes;
}

enum class Verdict { pending, no_contact, stop };

/// Whether surfaces intersect at the peg's target. One call of tick() per period.
class Check {
 public:
  explicit Check(const flashbvh::Pose& pose) : pose_(pose), query_(plate, peg, pose_) {}
  Check(const Check&) = delete;  // the query points at pose_
  Check& operator=(const Check&) = delete;

  Verdict tick() {
    flashbvh::PairQuery::Pair found[1];
    status_ = query_.run(kWork, found).status;
    switch (status_) {
      case flashbvh::Status::suspended:
        return Verdict::pending;  // the next period goes on
      case flashbvh::Status::done:
        return Verdict::no_contact;
      default:
        return Verdict::stop;  // full: a pair was found; all others: an error
    }
  }

  bool has_contact() const { return status_ == flashbvh::Status::full; }
  flashbvh::Contact contact() const { return flashbvh::contact_of_last(query_); }

 private:
  flashbvh::Pose pose_;
  flashbvh::PairQuery query_;
  flashbvh::Status status_ = flashbvh::Status::suspended;
};

/// How high above the plate's drawn origin a contact lies, in mm and in nm.
float height_mm(const flashbvh::Contact& contact) {
  return flashbvh::in_unit(contact.ends[0], plate.cell_bits).z;
}
int64_t height_nm(const flashbvh::Contact& contact) {
  return flashbvh::millionths_of(contact.ends[0].z, plate.cell_bits);
}

/// Slow within 5 mm, stop within 1 mm. The pair that was nearest is where the next answer begins.
class Guard {
 public:
  enum class Speed { full, slow, stop };

  Speed at(const flashbvh::Pose& pose) {
    const auto known = flashbvh::distance(plate, peg, pose, nearest_);
    nearest_ = known.witness;
    if (known.status != flashbvh::Status::done || known.lower < within_mm(1)) {
      return Speed::stop;
    }
    return known.lower < within_mm(5) ? Speed::slow : Speed::full;
  }

 private:
  static uint32_t within_mm(float length) {
    return flashbvh::fine_distance(length, plate_CELLS_PER_UNIT);
  }

  flashbvh::Witness<uint16_t> nearest_;
};

/// Is the peg's path free? One call of tick() a period, before the move is queued.
class Travel {
 public:
  Travel(const flashbvh::Pose& from, const flashbvh::Pose& to)
      : motion_(flashbvh::BodyMotion::between(from, to)),
        query_(plate, peg, motion_, flashbvh::fine_distance(0.5f, plate_CELLS_PER_UNIT)) {}
  Travel(const Travel&) = delete;  // the query points at motion_
  Travel& operator=(const Travel&) = delete;

  Verdict tick() {
    const flashbvh::FirstContactAnswer answer = query_.run(kWork);
    if (answer.status == flashbvh::Status::suspended) {
      return Verdict::pending;
    }
    const bool is_free =
        answer.status == flashbvh::Status::done && answer.outcome == flashbvh::ContactOutcome::free;
    return is_free ? Verdict::no_contact : Verdict::stop;
  }

 private:
  flashbvh::BodyMotion motion_;
  flashbvh::FirstContact query_;
};

/// Made once; a pose moves it, as it moves any mesh.
class Cable {
 public:
  Cable() : axis_(plate, {0, 0, 0}, {0, 0, kLength}) {}

  /// Also true if the query cannot decide.
  bool touches_plate(const flashbvh::Pose& pose) const {
    const uint32_t radius = flashbvh::fine_distance(2, plate_CELLS_PER_UNIT);
    return axis_.status() != flashbvh::Status::done ||
           closer_than(plate, axis_.mesh(), pose, radius).yes;
  }

 private:
  static constexpr auto kLength = static_cast<int32_t>(20 * plate_CELLS_PER_UNIT);

  flashbvh::SegmentShape axis_;
};

/// How high a sensor is above the plate, in mm: `reach` if it sees nothing, 0 if unknown.
float height_seen(const float (&from)[3], float reach) {
  const float down[3] = {0, 0, -1};
  const auto ray = flashbvh::segment_of(from, down, reach, plate_CELLS_PER_UNIT);
  const auto found = nearest_hit(plate, ray.segment);
  if (ray.status != flashbvh::Status::done || found.status != flashbvh::Status::done) {
    return 0;
  }
  const uint32_t apart = found.yes ? distance_along(ray.segment, found.hit.along) : 0;
  return found.yes ? flashbvh::length_in_unit(apart, plate.cell_bits) : reach;
}

/// A peg of rubber: something else moves its vertices, each period.
class SoftPeg {
 public:
  SoftPeg() : mesh_(peg, nodes_, vertices_) {}
  SoftPeg(const SoftPeg&) = delete;  // the mesh points at its nodes
  SoftPeg& operator=(const SoftPeg&) = delete;

  flashbvh::Vertex* vertices() { return vertices_; }

  /// Call it after the vertices moved. Also true if the query cannot decide.
  bool touches_plate_or_itself(const flashbvh::Pose& pose) {
    return mesh_.refit().status != flashbvh::Status::done ||
           intersects(plate, mesh_.mesh(), pose).yes || intersects_itself(mesh_.mesh()).yes;
  }

 private:
  flashbvh::Node<uint16_t> nodes_[peg_NODE_COUNT];
  flashbvh::Vertex vertices_[peg_VERTEX_COUNT];
  flashbvh::DeformableMesh mesh_;
};

flashbvh::Mesh arm_links[cell_arm_LINK_COUNT];
const auto arm_robot = flashbvh::view_robot_unchecked(cell_arm_robot_image, arm_links);

/// Before the first period, at rest: start(). Then each period's set point goes to the drives only
/// if it may.
class ArmGuard {
 public:
  bool start(const float* joints) { return may_go(guard_.prime(set_point(joints))); }
  bool tick(const float* joints) { return may_go(guard_.update(set_point(joints), 150)); }

 private:
  using State =
      flashbvh::GuardStateOf<cell_arm_JOINT_COUNT, cell_arm_PAIR_COUNT, cell_arm_PAIR_JOINT_COUNT>;

  const flashbvh::JointCoordinate* set_point(const float* joints) {
    flashbvh::set_values(arm_robot, joints, values_);
    return values_;
  }
  static bool may_go(const flashbvh::GuardAnswer& answer) {
    return answer.status == flashbvh::Status::done && answer.verdict <= flashbvh::Verdict::warn;
  }

  flashbvh::JointCoordinate values_[cell_arm_VARIABLE_COUNT] = {};
  State state_;
  flashbvh::Guard guard_{arm_robot, state_};
};

/// The arm with a tool on its gripper, and a cart that drives by.
flashbvh::WorkcellOf<cell_arm_JOINT_COUNT + 2, cell_arm_LINK_COUNT + 2, cell_arm_PAIR_COUNT + 4, 40>
    room;
flashbvh::Workcell cell(arm_robot, room);
uint8_t tool_link;
uint8_t cart_link;

/// Before the guard is made. Meshes are baked with the arm's cell.
bool furnish(const flashbvh::Mesh& tool, const flashbvh::Mesh& cart,
             const flashbvh::Frame& cart_at) {
  constexpr auto done = flashbvh::Status::done;
  const flashbvh::Mount* const mounts = flashbvh::mounts(cell_arm_robot_image);
  return cell.add(tool, mounts[cell_arm_mount_gripper], tool_link) == done &&
         cell.add(cart, {flashbvh::kBase, cart_at}, cart_link) == done &&
         cell.keep_apart(cell_arm_link_base, tool_link, 3000, 9000) == done &&
         cell.keep_apart(cell_arm_link_forearm, cart_link, 9000, 30000) == done;
}

/// Before each period's update(): where the cart is, and the longest way of any point of it, in
/// 1/256 cell.
bool drive(const flashbvh::Frame& cart_at, uint32_t moved) {
  return cell.move(cart_link, cart_at, moved) == flashbvh::Status::done;
}

/// The verdict with the peg upright at this height; on a stop, gets the contact's height.
Verdict verdict_at(float height, float& mm, int64_t& nm) {
  const flashbvh::Pose world = flashbvh::Pose::translated(0, 0, 0);
  Check check(peg_in_plate(world, {1, 0, 0, 0}, 0, 0, height));
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
  const flashbvh::Pose plate_in_world = flashbvh::Pose::translated(0, 0, 0);
  for (const float height : {20.0f, 8.0f, 3.0f, 0.5f, 0.0f}) {
    const auto speed = guard.at(peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, height));
    if (speed != (height > 5   ? Guard::Speed::full
                  : height > 1 ? Guard::Speed::slow
                               : Guard::Speed::stop)) {
      return 2;
    }
  }
  const auto lowered_to = [&](float height) {
    return peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, height);
  };
  if (!may_go(lowered_to(0.5f)) || may_go(lowered_to(0)) || !is_near(lowered_to(3), 3.1f) ||
      is_near(lowered_to(3), 2.9f) || !is_clear(lowered_to(3), 2.9f) ||
      is_clear(lowered_to(3), 3)) {
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
  const flashbvh::Pose far_side = peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, -60);
  if (!travels(lowered_to(3), lowered_to(0.6f)) || travels(lowered_to(3), lowered_to(0.4f)) ||
      travels(lowered_to(20), far_side)) {
    return 8;
  }
  const Cable cable;
  if (!cable.touches_plate(peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, 1.9f)) ||
      cable.touches_plate(peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, 2.1f))) {
    return 3;
  }
  const float seen = height_seen({30, 20, 12}, 100);
  if (seen < 11.99f || seen > 12.01f || height_seen({30, 20, 12}, 5) != 5 ||
      height_seen({300, 20, 12}, 100) != 100 || height_seen({30, 20, 12}, -1) != 0) {
    return 4;
  }
  SoftPeg soft;
  const flashbvh::Pose above = peg_in_plate(plate_in_world, {1, 0, 0, 0}, 0, 0, 3);
  const bool apart = !soft.touches_plate_or_itself(above);
  for (uint32_t i = 0; i < peg_VERTEX_COUNT; ++i) {
    flashbvh::Vertex& v = soft.vertices()[i];
    v.z = static_cast<int16_t>(v.z < 0 ? 2 * v.z : v.z);
  }
  if (!apart || !soft.touches_plate_or_itself(above)) {
    return 6;
  }
  ArmGuard arm;
  const float upright[] = {0, 0, 0.5f, 0};
  const float folded[] = {0, 0.2f, 2.9f, 1.5f};
  if (!arm.start(upright) || !arm.tick(upright) || arm.start(folded)) {
    return 5;
  }
  const flashbvh::Mesh& body = arm_robot.meshes[cell_arm_link_gripper];
  flashbvh::Frame cart_at = flashbvh::kIdentityFrame;
  if (!furnish(body, body, cart_at) || !drive(cart_at, 256)) {
    return 6;
  }
  return verdict_at(0.5f, mm, nm) == Verdict::no_contact && mm == 1 &&
                 verdict_at(0, mm, nm) == Verdict::stop && mm > -0.01f && mm < 0.01f &&
                 nm > -10000 && nm < 10000
             ? 0
             : 1;
}
