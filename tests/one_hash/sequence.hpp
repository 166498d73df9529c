// Queries and guard periods with equal answers wherever flashbvh runs: one definition of the inputs
// and of the hash. Inputs are floats made of integers, so each language reads them unchanged.
#pragma once

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"
#include "support/rotations.hpp"

namespace one_hash {

using flashbvh::test::Random;

constexpr uint64_t kSeed = 0x6F6E6568617368u;
/// The number of queries of one `Kind`; after all kinds, the meshes change.
constexpr uint32_t kBlock = 1000;
enum class Kind : uint8_t { intersects, distance, first_pair };
constexpr uint32_t kKinds = 3;
/// The first of them, which Python has, too.
constexpr uint32_t kKindsOfPython = 2;
constexpr uint32_t kMeshes = 3;
/// The budgets of the first period, the largest that is a limit, and of those that follow.
constexpr uint32_t kAllWork = UINT32_MAX - 1;
constexpr uint32_t kWork = 150;
constexpr uint32_t kVariables = 4;

/// FNV-1a by words.
class Hash {
 public:
  void add(uint32_t word) { value_ = (value_ ^ word) * 16777619u; }
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
    const auto rotation = flashbvh::test::rotation_of(flashbvh::test::any_quaternion(random_));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        pose.rotation[i][j] = static_cast<float>(rotation.entry[i][j]) / flashbvh::kRotationOne;
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

/// The hash of this number of queries, of so many kinds, then of periods.
uint32_t hash_of(uint32_t queries, uint32_t periods, uint32_t kinds = kKinds);

/// The baked images, for other programs.
struct Image {
  const char* name;
  const uint32_t* words;
  uint32_t bytes;
};
constexpr uint32_t kImages = kMeshes + 1;
extern const Image kImage[kImages];

}  // namespace one_hash
