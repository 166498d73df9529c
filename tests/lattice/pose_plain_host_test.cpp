// Poses computed on this machine, possibly with vectors, against the microcontrollers' plain form,
// bit by bit. This file compiles the plain form under another name, and calls the library's form by
// its C interface.
#define FLASHBVH_PORTABLE
#define flashbvh plain
#include "lattice/pose.cpp"  // NOLINT(bugprone-suspicious-include)
//
#include "flashbvh/float.hpp"
#include "support/rotations.hpp"
#include "support/rounds.hpp"
#undef flashbvh

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "flashbvh/flashbvh.h"

namespace {

using plain::Pose;
using plain::test::for_rounds;
using plain::test::Random;
using Limits = std::numeric_limits<float>;

static_assert(sizeof(flashbvh_pose) >= sizeof(Pose));

/// The bytes of the library's pose, under the plain name.
Pose renamed(const flashbvh_pose& pose) {
  Pose same = Pose::translated(0, 0, 0);
  std::memcpy(static_cast<void*>(&same), &pose, sizeof same);
  return same;
}

void check_same(const flashbvh_pose& by_library, const Pose& wanted) {
  const Pose pose = renamed(by_library);
  REQUIRE(pose.status() == wanted.status());
  REQUIRE(pose.is_translation() == wanted.is_translation());
  for (int i = 0; i < 3; ++i) {
    REQUIRE(pose.translation(i) == wanted.translation(i));
    REQUIRE(pose.fraction(i) == wanted.fraction(i));
    for (int j = 0; j < 3; ++j) {
      REQUIRE(pose.rotation(i, j) == wanted.rotation(i, j));
    }
  }
  if (!pose.is_translation()) {
    REQUIRE(std::memcmp(&pose.matrix().rows, &wanted.matrix().rows, sizeof wanted.matrix().rows) ==
            0);
    REQUIRE(std::memcmp(pose.matrix().rest, wanted.matrix().rest, sizeof wanted.matrix().rest) ==
            0);
    REQUIRE(pose.matrix().defect == wanted.matrix().defect);
  }
}

/// value * 2^n, with a random n from `low` to `high`.
float scaled(Random& random, std::int32_t value, std::int32_t low, std::int32_t high) {
  return std::ldexp(static_cast<float>(value), random.between(low, high));
}

/// Numbers at which forms may differ: no number, limits, subnormals, halves between two results.
float any_odd_number(Random& random) {
  constexpr float odd[] = {0,
                           1,
                           2,
                           0.5f,
                           536870912,
                           1073741824,
                           70368744177664,
                           Limits::quiet_NaN(),
                           Limits::infinity(),
                           Limits::max(),
                           Limits::min(),
                           Limits::denorm_min()};
  const float size = random.one_of(odd);
  const float any = random.below(2) == 0 ? size : -size;
  switch (random.below(4)) {
    case 0:
      return any;
    case 1:  // next to one of them
      return std::nextafter(any, random.below(2) == 0 ? Limits::max() : Limits::lowest());
    case 2: {  // any bits
      const std::uint32_t high = random.below(1u << 16);
      const std::uint32_t bits = high << 16 | random.below(1u << 16);
      float value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }
    default: {  // halves and their neighbours, of each size
      const float half = scaled(random, 2 * random.between(-999, 999) + 1, -60, 0);
      return half + scaled(random, random.between(-1, 1), -60, -20);
    }
  }
}

/// Sets a rounding mode, and whether subnormals flush to zero, during its lifetime.
class FpuMode {
 public:
#if defined(__SSE2__)
  explicit FpuMode(Random& random) : before_(_mm_getcsr()) {
    constexpr unsigned flush = 0x8040;
    const unsigned rounding = random.below(4) << 13;
    _mm_setcsr(before_ | rounding | (random.below(2) == 0 ? flush : 0));
  }
  ~FpuMode() {
    _mm_setcsr(before_);
  }

 private:
  unsigned before_;
#else
  explicit FpuMode(Random&) {}
#endif
};

struct Numbers {
  float rotation[9];
  float translation[3];
  float cells_per_unit;
};

/// A mostly valid pose, with some odd numbers.
Numbers any_numbers(Random& random) {
  const auto rotation = plain::test::rotation_of(plain::test::any_quaternion(random));
  Numbers numbers{};
  const bool is_turned = random.below(4) != 0;
  for (int i = 0; i < 9; ++i) {
    const float entry = static_cast<float>(rotation.entry[i / 3][i % 3]) / plain::kRotationOne;
    numbers.rotation[i] = is_turned ? entry : i % 4 == 0 ? 1.0f : 0.0f;
  }
  if (random.below(4) == 0) {  // near the tolerance, mirrored, or with bits that round away
    float& entry = numbers.rotation[random.below(9)];
    entry =
        random.below(4) == 0 ? -entry : entry + scaled(random, random.between(-99, 99), -40, -14);
  }
  for (float& t : numbers.translation) {
    t = scaled(random, random.between(-16777215, 16777215), -40, 8);
  }
  numbers.cells_per_unit =
      random.below(2) == 0 ? 1.0f : scaled(random, random.between(1, 16777215), -40, 0);
  const std::uint32_t odd = random.below(40);
  if (odd < 9) {
    numbers.rotation[odd] = any_odd_number(random);
  } else if (odd < 12) {
    numbers.translation[odd - 9] = any_odd_number(random);
  } else if (odd == 12) {
    numbers.cells_per_unit = any_odd_number(random);
  } else if (odd <= 14) {  // relevant subnormals: of the length, or of the unit
    const float small = Limits::denorm_min() * static_cast<float>(random.between(1, 1 << 22));
    const float large = std::ldexp(1.0f, random.between(80, 127));
    numbers.translation[0] = odd == 13 ? small : large;
    numbers.translation[1] = numbers.translation[2] = 0;
    numbers.cells_per_unit = odd == 13 ? large : small;
  }
  return numbers;
}

}  // namespace

TEST_CASE(
    "the library's poses of floats have the bits of the plain form, in each mode of the FPU") {
  int refused = 0;
  for_rounds(400000, 1, [&](Random& random, int) {
    const Numbers numbers = any_numbers(random);
    const float(&r)[9] = numbers.rotation;
    const Pose wanted = plain::pose_of({{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}},
                                       numbers.translation, numbers.cells_per_unit);
    flashbvh_pose pose;
    const FpuMode mode(random);
    (void)flashbvh_pose_of_matrix(r, numbers.translation, numbers.cells_per_unit, &pose);
    check_same(pose, wanted);
    refused += wanted.status() == plain::Status::done ? 0 : 1;
  });
  CHECK(refused > 40000);
  CHECK(refused < 300000);
}

TEST_CASE("the library's poses of quaternions have the bits of the plain form") {
  for_rounds(100000, 2, [&](Random& random, int) {
    const Numbers numbers = any_numbers(random);
    const auto q = plain::test::any_quaternion(random);
    const double w = q.w, x = q.x, y = q.y, z = q.z;
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    float parts[4] = {static_cast<float>(w / length), static_cast<float>(x / length),
                      static_cast<float>(y / length), static_cast<float>(z / length)};
    if (random.below(8) == 0) {
      parts[random.below(4)] = any_odd_number(random);
    }
    flashbvh_pose pose;
    (void)flashbvh_pose_of_quaternion(parts, numbers.translation, numbers.cells_per_unit, &pose);
    check_same(pose, plain::pose_of(plain::UnitQuaternion{parts[0], parts[1], parts[2], parts[3]},
                                    numbers.translation, numbers.cells_per_unit));
  });
}

TEST_CASE("the library's rigid poses have the bits of the plain form") {
  for_rounds(200000, 3, [&](Random& random, int) {
    auto rotation = plain::test::rotation_of(plain::test::any_quaternion(random));
    std::int32_t& entry = rotation.entry[random.below(3)][random.below(3)];
    switch (random.below(8)) {
      case 0:
        entry = random.below(2) == 0 ? INT32_MAX : INT32_MIN;
        break;
      case 1:
        entry = -entry;
        break;
      case 2:
        entry += random.between(-200000, 200000);
        break;
      case 3:
        entry = random.between(INT32_MIN / 2, INT32_MAX / 2) * 2;
        break;
      default:
        break;
    }
    const std::int32_t cells[3] = {random.between(-600000000, 600000000), random.between(-9, 9), 7};
    const std::int16_t fraction[3] = {static_cast<std::int16_t>(random.between(-32768, 32767)),
                                      INT16_MIN, INT16_MAX};
    flashbvh_pose pose;
    (void)flashbvh_pose_rigid(rotation.entry[0], cells, fraction, &pose);
    check_same(pose, Pose::rigid(rotation.entry, cells, fraction));
  });
}

TEST_CASE("the library's products and inverses have the bits of the plain form") {
  const auto make = [](Random& random, flashbvh_pose& by_library) {
    const auto rotation = plain::test::rotation_of(plain::test::any_quaternion(random));
    const std::int32_t cells[3] = {random.between(-90000, 90000), random.between(-9, 9), 7};
    const std::int16_t fraction[3] = {static_cast<std::int16_t>(random.between(-32768, 32767)), 0,
                                      INT16_MAX};
    (void)flashbvh_pose_rigid(rotation.entry[0], cells, fraction, &by_library);
    return Pose::rigid(rotation.entry, cells, fraction);
  };
  for_rounds(100000, 4, [&](Random& random, int) {
    flashbvh_pose a;
    flashbvh_pose b;
    flashbvh_pose made;
    const Pose plain_a = make(random, a);
    const Pose plain_b = make(random, b);
    (void)flashbvh_pose_composed(&a, &b, &made);
    check_same(made, Pose::composed(plain_a, plain_b));
    (void)flashbvh_pose_relative(&a, &b, &made);
    check_same(made, Pose::relative(plain_a, plain_b));
    (void)flashbvh_pose_inverse(&a, &made);
    check_same(made, plain_a.inverse());
  });
}
