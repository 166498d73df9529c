// Poses from floats: their rounding, and refusals.
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "flashbvh/float.hpp"
#include "support/rotations.hpp"
#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kNoRotation[] = {kNan, -kNan, kInfinity, -kInfinity, kLargest, -kLargest, 2, -2, 5};
constexpr float kNowhere[] = {kNan,     -kNan,     kInfinity, -kInfinity,
                              kLargest, -kLargest, 5.4e8f,    -5.4e8f};
constexpr float kOrigin[3] = {0, 0, 0};
constexpr UnitQuaternion kUnrotated = {1, 0, 0, 0};

UnitQuaternion scaled(const Quaternion& q, double length) {
  const double w = q.w, x = q.x, y = q.y, z = q.z;
  const double scale = length / std::sqrt(w * w + x * x + y * y + z * z);
  return {static_cast<float>(w * scale), static_cast<float>(x * scale),
          static_cast<float>(y * scale), static_cast<float>(z * scale)};
}

/// The difference between the pose's rotation and the quaternion's, computed in doubles, in a
/// rotation's fixed point.
double distance(const Pose& pose, const UnitQuaternion& q) {
  const double w = static_cast<double>(q.w), x = static_cast<double>(q.x);
  const double y = static_cast<double>(q.y), z = static_cast<double>(q.z);
  const double square = w * w + x * x + y * y + z * z;
  const double exact[3][3] = {
      {w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w)},
      {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w)},
      {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z}};
  double most = 0;
  for_entries([&](int i, int j) {
    most = std::fmax(most, std::fabs(pose.rotation(i, j) - exact[i][j] / square * kRotationOne));
  });
  return most;
}

/// A pose's rounding: half of 2^-22, and the 2^-27 of a quaternion.
constexpr double kRounding = 128 + 8;

}  // namespace

TEST_CASE("a matrix of floats is the pose of the same numbers in fixed point") {
  for_rounds(500, [&](Random& random, int) {
    Rotation rotation = rotation_of(any_quaternion(random));
    float matrix[3][3];
    float rows[3][4] = {{0, 0, 0, 7}, {0, 0, 0, -8}, {0, 0, 0, 9}};
    for_entries([&](int i, int j) {
      std::int32_t& entry = rotation.entry[i][j];
      matrix[i][j] = rows[i][j] = static_cast<float>(entry) / kRotationOne;
      // Doubles hold the product exactly.
      entry =
          static_cast<std::int32_t>(std::round(static_cast<double>(matrix[i][j]) * kRotationOne));
    });
    const Pose wanted = Pose::rigid(rotation.entry, {7, -8, 9});
    for (const Pose& pose : {pose_of(matrix, {7, -8, 9}, 1), pose_of(rows, 1)}) {
      REQUIRE(pose.status() == Status::done);
      for_entries([&](int i, int j) {
        CHECK(pose.rotation(i, j) == wanted.rotation(i, j));
        CHECK(pose.translation(i) == wanted.translation(i));
      });
    }
  });
}

TEST_CASE("a quaternion's rounding is normalised away, up to the tolerance") {
  for_rounds(500, [&](Random& random, int) {
    const Quaternion q = any_quaternion(random);
    // The squared length is off by 2^-10, or 9.77e-4.
    for (const double length : {1.0, 1 + 4.8e-4, 1 - 4.8e-4}) {
      CAPTURE(length);
      const UnitQuaternion unit = scaled(q, length);
      const Pose pose = pose_of(unit, kOrigin, 1);
      REQUIRE(pose.status() == Status::done);
      REQUIRE(distance(pose, unit) <= kRounding);
    }
    for (const double length : {0.0, 0.5, 1 - 5.0e-4, 1 + 5.0e-4, 2.0, 1e9, 1e30}) {
      CAPTURE(length);
      REQUIRE(pose_of(scaled(q, length), kOrigin, 1).status() == Status::not_a_rotation);
    }
  });
}

TEST_CASE("translations are multiplied and rounded once, to 1/65,536 of a cell") {
  for_rounds(2000, [&](Random& random, int) {
    // Any size, down to products that round to zero.
    const auto of_length = static_cast<float>(random.between(-16777215, 16777215));
    const float length = std::ldexp(of_length, random.between(-70, 10));
    const auto of_scale = static_cast<float>(random.between(1, 16777215));
    const float scale = std::ldexp(of_scale, random.between(-40, 10));
    CAPTURE(length, scale);
    const Pose pose = pose_of(kUnrotated, {0, length, 0}, scale);
    // 48 bits at most: exact in double.
    const double cells = static_cast<double>(length) * static_cast<double>(scale);
    const Pose by_rows = pose_of({{1, 0, 0, 0}, {0, 1, 0, length}, {0, 0, 1, 0}}, scale);
    REQUIRE(by_rows.status() == pose.status());
    CHECK(by_rows.translation(1) == pose.translation(1));
    CHECK(by_rows.fraction(1) == pose.fraction(1));
    if (std::fabs(cells) >= kMaxTranslation + 1.0) {
      REQUIRE(pose.status() == Status::translation_out_of_range);
    } else if (std::fabs(cells) <= kMaxTranslation) {
      REQUIRE(pose.status() == Status::done);
      CHECK(pose.translation(1) * 65536.0 + pose.fraction(1) == std::round(cells * 65536));
      CHECK(pose.translation(0) == 0);
      CHECK(pose.fraction(2) == 0);
    }
  });
  const Pose halves = pose_of(kUnrotated, {0.5f, -0.5f, 2.5f}, 3);
  CHECK((halves.translation(0) == 2 && halves.fraction(0) == -32768));
  CHECK((halves.translation(1) == -1 && halves.fraction(1) == -32768));
  CHECK((halves.translation(2) == 8 && halves.fraction(2) == -32768));
}

TEST_CASE("translations up to the last cell are taken, none beyond") {
  constexpr float most = kMaxTranslation;
  CHECK(pose_of(kUnrotated, {most, -most, 0}, 1).status() == Status::done);
  CHECK(pose_of(kUnrotated, {most / 4, -most / 4, 0}, 4).translation(1) == -kMaxTranslation);
  const float beyond = std::nextafter(most, kLargest);
  CHECK(pose_of(kUnrotated, {beyond, 0, 0}, 1).status() == Status::translation_out_of_range);
  CHECK(pose_of(kUnrotated, {0, -beyond, 0}, 1).status() == Status::translation_out_of_range);
  const float tiny = std::numeric_limits<float>::denorm_min();
  CHECK(pose_of(kUnrotated, {tiny, -tiny, 0}, 1).fraction(1) == 0);
  CHECK(pose_of(kUnrotated, {tiny, 1, 0}, tiny).status() == Status::done);
}

TEST_CASE("what is no number or out of range is a status, wherever it stands") {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float bad : kNowhere) {
      CAPTURE(axis, bad);
      float translated[3] = {1, 2, 3};
      translated[axis] = bad;
      CHECK(pose_of(kUnrotated, translated, 1).status() == Status::translation_out_of_range);
    }
  }
  for_entries([](int row, int column) {
    for (const float bad : kNoRotation) {
      CAPTURE(row, column, bad);
      float matrix[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      matrix[row][column] = bad;
      CHECK(pose_of(matrix, kOrigin, 1).status() == Status::not_a_rotation);
      CHECK(pose_of(matrix, {kNan, 0, 0}, 1).status() == Status::translation_out_of_range);
    }
  });
  for (const float bad : kNoRotation) {
    CHECK(pose_of(UnitQuaternion{bad, 0, 0, 0}, kOrigin, 1).status() == Status::not_a_rotation);
    CHECK(pose_of(UnitQuaternion{0, bad, 0, 1}, kOrigin, 1).status() == Status::not_a_rotation);
    CHECK(pose_of(UnitQuaternion{1, 0, bad, 0}, kOrigin, 1).status() == Status::not_a_rotation);
    CHECK(pose_of(UnitQuaternion{bad, bad, bad, bad}, kOrigin, 1).status() ==
          Status::not_a_rotation);
  }
  for (const float bad : {0.0f, -0.0f, -1.0f, kNan, kInfinity, -kInfinity}) {
    CAPTURE(bad);
    CHECK(pose_of(kUnrotated, kOrigin, bad).status() == Status::translation_out_of_range);
  }
}

TEST_CASE(
    "matrices that mirror, scale or shear are refused, and an unrotated one only translates") {
  CHECK(pose_of({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, kOrigin, 1).status() == Status::not_a_rotation);
  CHECK(pose_of({{1, 0, 0}, {0, 1.01f, 0}, {0, 0, 1}}, kOrigin, 1).status() ==
        Status::not_a_rotation);
  CHECK(pose_of({{1, 0.01f, 0}, {0, 1, 0}, {0, 0, 1}}, kOrigin, 1).status() ==
        Status::not_a_rotation);
  CHECK(pose_of({{1, -0.0f, 0}, {0, 1, 0}, {0, 0, 1}}, kOrigin, 1).is_translation());
  CHECK(pose_of(kUnrotated, kOrigin, 1).is_translation());
  CHECK(pose_of(UnitQuaternion{-1, 0, 0, 0}, kOrigin, 1).is_translation());
}
