// Queries and guard periods with equal answers wherever flashbvh runs. Inputs are floats made of
// integers, so each language reads them unchanged.
//
// one_hash           prints the hash of all queries and periods; exits with 0 if it is the hash of
//                    every core and compiler
// one_hash FOLDER    prints the hash without the queries that Python lacks; writes the input of
//                    answers.py to FOLDER: images, poses and joint values
#include "cell_arm.robot.h"
#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"
#include "flashbvh/robot/robot_float.hpp"
#include "gear.fbvh.h"
#include "lump.fbvh.h"
#include "support/print.hpp"
#include "support/rotations.hpp"
#include "torus.fbvh.h"

#if !defined(FLASHBVH_ON_BOARD)
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>
#endif

using namespace flashbvh;
using flashbvh::test::Hexadecimal;
using flashbvh::test::print;
using flashbvh::test::Random;

namespace {

constexpr uint64_t kSeed = 0x6F6E6568617368u;
constexpr uint32_t kExpected = 0x2DAC55F5;
constexpr uint32_t kQueries = 10000;
constexpr uint32_t kPeriods = 10000;
/// The number of queries of one kind; after all kinds, the meshes change.
constexpr uint32_t kBlock = 1000;
/// Budgets of the first period, the largest that is a limit, and of those that follow.
constexpr uint32_t kAllWork = UINT32_MAX - 1;
constexpr uint32_t kWork = 150;
constexpr uint32_t kVariables = cell_arm_VARIABLE_COUNT;

/// FNV-1a by words.
class Hash {
 public:
  void add(uint32_t word) { value_ = (value_ ^ word) * 16777619u; }
  void add(const TrianglePair<uint16_t>& pair) {
    add(pair.a | static_cast<uint32_t>(pair.b) << 16);
  }
  void add(const FinePoint& point) {
    add(static_cast<uint32_t>(point.x));
    add(static_cast<uint32_t>(point.y));
    add(static_cast<uint32_t>(point.z));
  }
  uint32_t value() const { return value_; }

 private:
  uint32_t value_ = 2166136261u;
};

/// The frame of B in A's frame.
struct PoseFloats {
  float rotation[3][3];  ///< row by row
  float translation[3];  ///< mm
};

class Poses {
 public:
  PoseFloats next() {
    PoseFloats pose{};
    const auto rotation = test::rotation_of(test::any_quaternion(random_));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        pose.rotation[i][j] = static_cast<float>(rotation.entry[i][j]) / kRotationOne;
      }
      pose.translation[i] = static_cast<float>(random_.between(-kReach, kReach)) / kPerMillimetre;
    }
    return pose;
  }

 private:
  static constexpr int32_t kPerMillimetre = 64;
  static constexpr int32_t kReach = 40 * kPerMillimetre;

  Random random_{kSeed};
};

/// Joint values of the arm, in radians: they wander between limits slightly beyond the arm's.
struct ValueFloats {
  float radians[kVariables];
};

class Trajectory {
 public:
  ValueFloats next() {
    ValueFloats values{};
    for (uint32_t i = 0; i < kVariables; ++i) {
      if (random_.below(kPeriodsAWay) == 0) {
        velocity_[i] = random_.between(-kFastest, kFastest);
      }
      if (at_[i] + velocity_[i] < kLimits[i][0] || at_[i] + velocity_[i] > kLimits[i][1]) {
        velocity_[i] = -velocity_[i];
      }
      at_[i] += velocity_[i];
      values.radians[i] = static_cast<float>(at_[i]) / kPerRadian;
    }
    return values;
  }

 private:
  static constexpr int32_t kPerRadian = 1 << 20;
  static constexpr int32_t kFastest = 4096;
  static constexpr uint32_t kPeriodsAWay = 200;
  static constexpr int32_t kLimits[kVariables][2] = {
      {-2940000, 2940000}, {-1260000, 1890000}, {-3096000, 3096000}, {-9000000, 9000000}};

  Random random_{kSeed + 1};
  int32_t at_[kVariables] = {};
  int32_t velocity_[kVariables] = {};
};

void add_intersects(const Mesh& a, const Mesh& b, const Pose& pose, Hash& hash) {
  hash.add(intersects(a, b, pose).yes ? 1 : 0);
}

void add_distance(const Mesh& a, const Mesh& b, const Pose& pose, Hash& hash) {
  const Clearance<uint16_t> found = distance(a, b, pose);
  hash.add(found.lower);
  hash.add(found.upper);
  hash.add(found.triangles);
  hash.add(found.point_a);
  hash.add(found.point_b);
}

void add_first_pair(const Mesh& a, const Mesh& b, const Pose& pose, Hash& hash) {
  TrianglePair<uint16_t> pair{};
  hash.add(first_pair(a, b, pose, pair).yes ? 1 : 0);
  hash.add(pair);
}

/// The first `kinds` of these.
void add_queries(uint32_t kinds, Hash& hash) {
  constexpr void (*add_kind[])(const Mesh&, const Mesh&, const Pose&, Hash&) = {
      add_intersects, add_distance, add_first_pair};
  const Mesh meshes[] = {view_unchecked<Mesh>(torus_image), view_unchecked<Mesh>(lump_image),
                         view_unchecked<Mesh>(gear_image)};
  const float cells = cells_per_unit(meshes[0].cell_bits);
  Poses poses;
  for (uint32_t i = 0; i < kQueries; ++i) {
    const uint32_t block = i / kBlock;
    const uint32_t a = block / kinds % 3;
    const PoseFloats at = poses.next();
    add_kind[block % kinds](meshes[a], meshes[(a + 1) % 3],
                            pose_of(at.rotation, at.translation, cells), hash);
  }
}

Mesh links[cell_arm_LINK_COUNT];
GuardStateOf<cell_arm_JOINT_COUNT, cell_arm_PAIR_COUNT, cell_arm_PAIR_JOINT_COUNT> state;

void add_periods(Hash& hash) {
  const Robot robot = view_robot_unchecked(cell_arm_robot_image, links);
  Guard guard(robot, state);
  Trajectory trajectory;
  for (uint32_t i = 0; i < kPeriods; ++i) {
    JointCoordinate values[kVariables];
    set_values(robot, trajectory.next().radians, values);
    const GuardAnswer answer = guard.update(values, i == 0 ? kAllWork : kWork);
    hash.add(static_cast<uint32_t>(answer.verdict));
    hash.add(answer.pair);
    hash.add(answer.distance);
    hash.add(answer.work);
  }
}

uint32_t hash_of(uint32_t kinds) {
  Hash hash;
  add_queries(kinds, hash);
  add_periods(hash);
  return hash.value();
}

#if !defined(FLASHBVH_ON_BOARD)
bool write(const std::string& path, const void* data, std::size_t bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  return file.flush().good();
}

template <class Inputs>
bool write_inputs(const std::string& path, std::uint32_t count) {
  Inputs inputs;
  std::vector<decltype(inputs.next())> all(count);
  std::generate(all.begin(), all.end(), [&] { return inputs.next(); });
  return write(path, all.data(), count * sizeof all[0]);
}

bool write_all(const std::string& folder) {
  return write_inputs<Poses>(folder + "/poses", kQueries) &&
         write_inputs<Trajectory>(folder + "/values", kPeriods) &&
         write(folder + "/torus.fbvh", torus_image, torus_IMAGE_BYTES) &&
         write(folder + "/lump.fbvh", lump_image, lump_IMAGE_BYTES) &&
         write(folder + "/gear.fbvh", gear_image, gear_IMAGE_BYTES) &&
         write(folder + "/arm.robot", cell_arm_robot_image, cell_arm_IMAGE_BYTES);
}
#endif

}  // namespace

#if defined(FLASHBVH_ON_BOARD)
int main() {
#else
int main(int argc, char** argv) {
  if (argc == 2) {
    constexpr uint32_t kinds_of_python = 2;
    print(Hexadecimal(hash_of(kinds_of_python)).text, "\n");
    return write_all(argv[1]) ? 0 : 2;
  }
#endif
  constexpr uint32_t kinds = 3;
  const uint32_t hash = hash_of(kinds);
  print(kQueries, " queries and ", kPeriods, " periods: ", Hexadecimal(hash).text, "\n");
  if (hash != kExpected) {
    print("expected: ", Hexadecimal(kExpected).text, "\n");
  }
  return hash == kExpected ? 0 : 1;
}
