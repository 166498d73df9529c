#include "support/arms/exercise_robot.hpp"
#include "support/same_view.hpp"

#include <cstring>
#include <memory>
#include <vector>

#include "flashbvh/detail/robot/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/motion.hpp"

namespace flashbvh::test {
namespace {

using Number = std::function<std::uint32_t()>;
using Values = std::vector<JointCoordinate>;

/// The errors that values may get, and the status of links too far apart for queries.
bool may_be(Status status) {
  return status == Status::done || status == Status::suspended ||
         status == Status::not_a_coordinate || status == Status::joint_out_of_limits ||
         status == Status::joint_jumped || status == Status::distance_out_of_range;
}

/// Random values within the limits of the joints that are no mimics.
Values any_values(const Robot& robot, const Number& number) {
  Values values(robot.variable_count);
  for (std::uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.shift == 0) {
      const std::int64_t any = number();
      const std::int64_t span = std::int64_t{joint.upper} - joint.lower + 1;
      values[joint.variable] = static_cast<JointCoordinate>(
          joint.type == JointType::continuous ? any + INT32_MIN : joint.lower + any % span);
    }
  }
  return values;
}

const char* guard_it(const Robot& robot, const Number& number) {
  static GuardStateOf<kMaxJoints, 256, 4096> state;  // too large for a stack
  Guard guard(robot, state);
  std::uint32_t joints = 0;
  for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
    joints += robot.pairs[i].joints_a + robot.pairs[i].joints_b;
  }
  if (robot.pair_count > 256 || joints > 4096) {
    return guard.prime(nullptr).status == Status::guard_state_invalid ? nullptr : "a small state";
  }
  Values values = any_values(robot, number);
  if (!may_be(guard.prime(values.data()).status)) {
    return "the guard's first period ends in an error";
  }
  for (int period = 0; period < 3; ++period) {
    const Values to = any_values(robot, number);
    for (std::size_t i = 0; i < to.size() && period != 1; ++i) {
      values[i] = to[i] / 16 + (values[i] - values[i] / 16);  // nearer
    }
    if (!may_be(
            guard.update(period == 1 ? to.data() : values.data(), period == 0 ? 300 : UINT32_MAX)
                .status)) {
      return "a period of the guard ends in an error";
    }
  }
  if (number() % 2 == 0) {  // as if copied out and back, and damaged
    auto* const bytes = reinterpret_cast<unsigned char*>(&state);
    for (std::uint32_t i = number() % 4; i != 0; --i) {
      const std::uint32_t reach = std::uint32_t{8} << number() % 12;
      bytes[number() % (reach < sizeof state ? reach : sizeof state)] ^=
          static_cast<unsigned char>(number());
    }
    if (guard.resume() == Status::done && !may_be(guard.update(values.data(), 300).status)) {
      return "a period after taking up a state ends in an error";
    }
  }
  const Status last = guard.go_on(UINT32_MAX).status;  // invalid if no values were accepted
  return may_be(last) || last == Status::guard_state_invalid ? nullptr
                                                             : "going on ends in an error";
}

const char* certify_it(const Robot& robot, const Number& number) {
  static MotionStateOf<kMaxJoints, kMaxJoints> state;
  MotionQuery motion(robot, state);
  const Values from = any_values(robot, number);
  const Values to = any_values(robot, number);
  const Status started = motion.start(from.data(), to.data());
  return may_be(started) && may_be(motion.run(3000).status) ? nullptr : "a motion ends in an error";
}

}  // namespace

RobotVerdict exercise_robot(const void* bytes, std::size_t size, const Number& number) {
  const std::unique_ptr<unsigned char[]> exact(new unsigned char[size]);
  if (size != 0) {
    std::memcpy(exact.get(), bytes, size);
  }
  RobotImageHeader header{};
  std::memcpy(&header, exact.get(), size < sizeof header ? size : sizeof header);
  std::vector<Mesh> meshes(header.link_count);  // no more than there are links
  Robot robot{};
  RobotVerdict verdict;
  verdict.status = open_robot(exact.get(), size, meshes.data(), header.link_count, robot);
  if (verdict.status != Status::done) {
    verdict.wrong = robot.joints != nullptr ? "a robot is written that is refused" : nullptr;
    return verdict;
  }
  std::vector<Mesh> seen(header.link_count);
  if (!same_view(robot, view_robot_unchecked(exact.get(), seen.data()))) {
    verdict.wrong = "a view without a check is another one";
    return verdict;
  }
  for (std::uint32_t i = 0; i < unguarded_count(exact.get()); ++i) {
    if (unguarded_pairs(exact.get())[i].b >= robot.link_count) {
      verdict.wrong = "a pair that is not guarded is of no link";
      return verdict;
    }
  }
  const char* const last = link_name(exact.get(), robot.link_count - 1u);
  verdict.wrong = last + std::strlen(last) >= reinterpret_cast<const char*>(exact.get()) + size
                      ? "names go on after the end"
                      : guard_it(robot, number);
  verdict.wrong = verdict.wrong != nullptr ? verdict.wrong : certify_it(robot, number);
  return verdict;
}

void repair_robot(void* bytes, std::size_t size) {
  RobotImageHeader header;
  if (size < sizeof header) {
    return;
  }
  std::memcpy(&header, bytes, sizeof header);
  const std::uint32_t own = detail::robot_meshes_offset(header);
  if (own > size) {
    return;
  }
  header.crc = image_crc(bytes, own);
  std::memcpy(bytes, &header, sizeof header);
  std::vector<Mesh> meshes(kMaxLinks);
  Robot robot{};
  if (detail::open_robot_unhashed(bytes, size, meshes.data(), kMaxLinks, robot) == Status::done) {
    header.hash = robot_hash(robot);
    std::memcpy(bytes, &header, sizeof header);
    header.crc = image_crc(bytes, own);
    std::memcpy(bytes, &header, sizeof header);
  }
}

}  // namespace flashbvh::test
