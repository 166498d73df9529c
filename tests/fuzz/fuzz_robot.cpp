// Arbitrary bytes as a robot's image: refused, or a guard and a motion of the robot read nothing
// else and end (support/arms/exercise_robot.hpp).
//
// The input is an image; bytes after its end make joint values. Dependent fields are repaired
// first, since chance would not find them: magic, version, sizes, checksums, the hash, cells, and
// the pairs' joints in between.
#include <vector>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/detail/robot/image_parts.hpp"
#include "fuzz/fuzz.hpp"
#include "golden/exercise.hpp"
#include "support/arms/exercise_robot.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Repairs a mesh; returns the offset of the next one, or the input's end if it is cut off.
std::size_t repair_mesh(Bytes& bytes, std::size_t at, const RobotImageHeader& robot) {
  ImageHeader header;
  if (bytes.size() - at < sizeof header) {
    return bytes.size();
  }
  std::memcpy(&header, &bytes[at], sizeof header);
  header.magic = kImageMagic;
  header.version = kImageVersion;
  header.padding = 0;
  header.layout = static_cast<std::uint8_t>(Layout::post_indexed);
  header.index_bits = 16;
  header.unit = static_cast<std::uint8_t>(Unit::m);
  std::memcpy(header.cell, robot.cell, sizeof header.cell);
  const std::uint64_t size = image_offsets(header).end;
  const std::size_t left = bytes.size() - at;
  header.byte_count = static_cast<std::uint32_t>(size < left ? size : left);
  std::memcpy(&bytes[at], &header, sizeof header);
  repair_crc(&bytes[at], header.byte_count);
  return at + header.byte_count;
}

/// Repairs a pair of a robot whose arrays exist, with any contents.
void repair_pair(const Robot& robot, RobotPair& pair) {
  const std::uint8_t links[2] = {pair.a, pair.b};
  std::uint8_t counts[2] = {0, 0};
  std::uint8_t joints[2];
  std::uint32_t reach = 0;
  for (int i = 0; i < 2; ++i) {
    if (links[i] >= robot.link_count) {
      return;
    }
    joints[i] = robot.links[links[i]].joint;
  }
  while (joints[0] != joints[1]) {
    const int of = joints[1] == kBase || (joints[0] != kBase && joints[0] > joints[1]) ? 0 : 1;
    const std::uint32_t at = robot.links[links[of]].first_reach + std::uint32_t{counts[of]};
    if (joints[of] >= robot.joint_count || at >= robot.reach_count || counts[of] == kMaxJoints) {
      return;
    }
    reach += robot.reaches[at];
    ++counts[of];
    joints[of] = robot.joints[joints[of]].parent;
  }
  pair.joints_a = counts[0];
  pair.joints_b = counts[1];
  pair.reach = reach;
}

/// Keeps the header's counts; a robot whose counts do not fit is not repaired.
void repair_pairs(Bytes& bytes, RobotImageHeader& header) {
  Robot robot{};
  robot.joints = reinterpret_cast<const RobotJoint*>(&bytes[sizeof header]);
  robot.links = reinterpret_cast<const RobotLink*>(robot.joints + header.joint_count);
  auto* const pairs =
      reinterpret_cast<RobotPair*>(&bytes[sizeof header + header.joint_count * sizeof(RobotJoint) +
                                          header.link_count * sizeof(RobotLink)]);
  robot.reaches = reinterpret_cast<const std::uint32_t*>(pairs + header.pair_count);
  robot.joint_count = header.joint_count;
  robot.link_count = header.link_count;
  robot.reach_count = header.reach_count;
  header.pair_joint_count = 0;
  for (std::uint32_t i = 0; i < header.pair_count; ++i) {
    repair_pair(robot, pairs[i]);
    header.pair_joint_count += pairs[i].joints_a + pairs[i].joints_b;
  }
}

/// The image's part of the input, repaired as far as its header allows.
Bytes repaired(const std::uint8_t* input, std::size_t size) {
  Bytes bytes(input, input + size);
  RobotImageHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.magic = kRobotImageMagic;
  header.version = kRobotImageVersion;
  std::size_t end = robot_meshes_offset(header);
  if (end < size) {
    repair_pairs(bytes, header);
    for (std::uint32_t i = 0; i < header.link_count; ++i) {
      end = repair_mesh(bytes, end, header);
    }
    bytes.resize(end);
  }
  header.byte_count = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  repair_robot(bytes.data(), bytes.size());
  return bytes;
}

RobotVerdict exercise(const Bytes& image, Input rest) {
  return exercise_robot(image.data(), image.size(), [&] { return rest.take<std::uint32_t>(); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const Bytes whole(bytes, bytes + size);
  RobotVerdict verdict = exercise(whole, Input(bytes, size));  // unrepaired
  require(verdict.wrong == nullptr, verdict.wrong);
  if (size < sizeof(RobotImageHeader)) {
    return 0;
  }
  const Bytes image = repaired(bytes, size);
  verdict = exercise(image, Input(bytes + image.size(), size - image.size()));
  require(verdict.wrong == nullptr, verdict.wrong);
  return 0;
}
