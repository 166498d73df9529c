// Poses: accepted rotations, composition, inversion, and every status.
#include "flashbvh/pose.hpp"

#include <cstdint>
#include <cstdlib>
#include <initializer_list>

#include "support/rotations.hpp"
#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

constexpr std::int32_t kNowhere[3] = {0, 0, 0};
constexpr std::int32_t kOne = kRotationOne;

Rotation scaled(Rotation rotation, std::int32_t by) {
  for_entries([&](int i, int j) {
    std::int32_t& entry = rotation.entry[i][j];
    entry = static_cast<std::int32_t>(std::int64_t{entry} * by / kOne);
  });
  return rotation;
}

/// A component of the translation, in 1/65,536 cell.
std::int64_t fine_translation(const Pose& pose, int axis) {
  return std::int64_t{pose.translation(axis)} * 65536 + pose.fraction(axis);
}

/// R p + t in 1/65,536 cell, from the pose's own numbers; p in this unit, below 2^31.
std::int64_t transformed(const Pose& pose, const std::int64_t (&p)[3], int axis) {
  std::int64_t sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += pose.rotation(axis, i) * (p[i] / 1024);
  }
  return sum / (kOne / 1024) + fine_translation(pose, axis);
}

}  // namespace

TEST_CASE("every rotation of a cube is exact, and the identity is a translation") {
  int exact = 0;
  for (int index = 0; index < 81; ++index) {
    const Quaternion q = {index % 3 - 1, index / 3 % 3 - 1, index / 9 % 3 - 1, index / 27 - 1};
    if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) {
      continue;
    }
    const Pose pose = Pose::rigid(rotation_of(q).entry, kNowhere);
    REQUIRE(pose.status() == Status::done);
    const bool identity = q.x == 0 && q.y == 0 && q.z == 0;
    REQUIRE(pose.is_translation() == identity);
    int wholes = 0;
    for_entries([&](int i, int j) { wholes += std::abs(pose.rotation(i, j)) == kOne ? 1 : 0; });
    if (wholes == 3 && !identity) {
      ++exact;
      CHECK(pose.matrix().defect == 0);
    }
  }
  CHECK(exact > 20);
}

TEST_CASE("a pose keeps what it is given, to 2^-22") {
  for_rounds(1000, [&](Random& random, int) {
    const Rotation rotation = rotation_of(any_quaternion(random));
    const Pose pose = Pose::rigid(rotation.entry, {1, -2, 3}, {4, -5, 32767});
    REQUIRE(pose.status() == Status::done);
    for_entries([&](int i, int j) {
      REQUIRE(std::abs(pose.rotation(i, j) - rotation.entry[i][j]) <= 128);
    });
    CHECK(pose.translation(1) == -2);
    CHECK(pose.fraction(2) == 32767);
  });
}

TEST_CASE("a matrix that is no rotation within the tolerance is refused, not repaired") {
  for_rounds(300, 1, [&](Random& random, int) {
    const Rotation rotation = rotation_of(any_quaternion(random));
    // Scaling all entries changes a column's squared length by twice as much.
    const std::int32_t tolerated = kRotationTolerance / 2 - (kOne >> 16);
    const std::int32_t excessive = kRotationTolerance / 2 + (kOne >> 16);
    const auto status_at = [&](std::int32_t scale) {
      return Pose::rigid(scaled(rotation, scale).entry, kNowhere).status();
    };
    REQUIRE(status_at(kOne + tolerated) == Status::done);
    REQUIRE(status_at(kOne - tolerated) == Status::done);
    REQUIRE(status_at(kOne + excessive) == Status::not_a_rotation);
    REQUIRE(status_at(kOne - excessive) == Status::not_a_rotation);
    REQUIRE(status_at(-kOne) == Status::not_a_rotation);  // a mirror image
  });
  const std::int32_t zero[3][3] = {};
  CHECK(Pose::rigid(zero, kNowhere).status() == Status::not_a_rotation);
  for (const std::int32_t extreme : {INT32_MIN, INT32_MAX}) {
    for_entries([extreme](int i, int j) {
      std::int32_t wild[3][3] = {{kOne, 0, 0}, {0, kOne, 0}, {0, 0, kOne}};
      wild[i][j] = extreme;
      CHECK(Pose::rigid(wild, kNowhere).status() == Status::not_a_rotation);
    });
  }
  const std::int32_t sheared[3][3] = {{kOne, kOne >> 10, 0}, {0, kOne, 0}, {0, 0, kOne}};
  CHECK(Pose::rigid(sheared, kNowhere).status() == Status::not_a_rotation);
}

TEST_CASE("a translation out of range is a status of its own, however the pose is made") {
  const Rotation rotation = rotation_of({1, 1, 0, 0});
  for (const std::int32_t t : {kMaxTranslation + 1, -kMaxTranslation - 1, INT32_MAX, INT32_MIN}) {
    const Pose pose = Pose::rigid(rotation.entry, {0, t, 0});
    CHECK(pose.status() == Status::translation_out_of_range);
    CHECK(pose.inverse().status() == Status::translation_out_of_range);
    CHECK(Pose::composed(pose, Pose::translated(0, 0, 0)).status() ==
          Status::translation_out_of_range);
    CHECK(Pose::relative(Pose::translated(0, 0, 0), pose).status() ==
          Status::translation_out_of_range);
  }
  const Pose far = Pose::translated(kMaxTranslation, 0, 0);
  CHECK(Pose::composed(far, far).status() == Status::translation_out_of_range);
  CHECK(Pose::composed(far, far.inverse()).status() == Status::done);
  CHECK(Pose::rigid(rotation_of({3, 1, 2, 1}).entry, {kMaxTranslation, -kMaxTranslation, 0})
            .status() == Status::done);
}

TEST_CASE("a bad pose stays bad in whatever is made of it") {
  const std::int32_t zero[3][3] = {};
  const Pose bad = Pose::rigid(zero, kNowhere);
  const Pose good = Pose::rigid(rotation_of({1, 2, 3, 4}).entry, {5, 6, 7});
  CHECK(bad.inverse().status() == Status::not_a_rotation);
  CHECK(Pose::composed(bad, good).status() == Status::not_a_rotation);
  CHECK(Pose::composed(good, bad).status() == Status::not_a_rotation);
  CHECK(Pose::relative(good, bad).status() == Status::not_a_rotation);
}

TEST_CASE("composed does first the one, then the other") {
  for_rounds(500, 2, [&](Random& random, int) {
    const Pose outer = any_rigid_pose(random, 10000);
    const Pose inner = any_rigid_pose(random, 10000);
    const Pose both = Pose::composed(outer, inner);
    REQUIRE(both.status() == Status::done);
    std::int64_t p[3];
    for (std::int64_t& axis : p) {
      axis = std::int64_t{random.between(-16383, 16383)} * 65536;
    }
    const std::int64_t between[3] = {transformed(inner, p, 0), transformed(inner, p, 1),
                                     transformed(inner, p, 2)};
    for (int axis = 0; axis < 3; ++axis) {
      // Three matrices, with entries rounded to 2^-22: 16,383 cells times nine halves of that.
      REQUIRE(std::llabs(transformed(both, p, axis) - transformed(outer, between, axis)) <
              65536 / 32);
    }
  });
}

TEST_CASE("an inverse leads back, and to the relative pose of two objects in a world") {
  for_rounds(500, 3, [&](Random& random, int) {
    const Pose a = any_rigid_pose(random, 16383);
    const Pose b = any_rigid_pose(random, 16383);
    const Pose back = Pose::composed(a.inverse(), a);
    REQUIRE(back.status() == Status::done);
    for_entries([&](int i, int j) {
      REQUIRE(std::llabs(fine_translation(back, i)) < 65536 / 64);
      REQUIRE(std::abs(back.rotation(i, j) - (i == j ? kOne : 0)) <= 8 << 8);
    });
    const Pose relative = Pose::composed(a, Pose::relative(a, b));
    for (int i = 0; i < 3; ++i) {
      REQUIRE(std::llabs(fine_translation(relative, i) - fine_translation(b, i)) < 65536 / 16);
    }
  });
  // Exact if there is nothing to round.
  const Pose rotation = Pose::rigid(rotation_of({1, 1, 1, 1}).entry, {1, 2, 3}, {-32768, 5, 0});
  const Pose back = Pose::composed(rotation, rotation.inverse());
  CHECK(back.is_translation());
  for (int i = 0; i < 3; ++i) {
    CHECK(fine_translation(back, i) == 0);
  }
}

TEST_CASE("a pose's defect bounds how far it is from a rotation, however it was made") {
  Random random = test_random(7);
  const auto check = [&random](const Pose& pose) {
    double square[3][3];  // R^T R - 1
    for_entries([&](int j, int k) {
      square[j][k] = j == k ? -1 : 0;
      for (int i = 0; i < 3; ++i) {
        square[j][k] +=
            static_cast<double>(pose.rotation(i, j)) / kOne * pose.rotation(i, k) / kOne;
      }
    });
    const double defect = pose.is_translation() ? 0 : pose.matrix().defect / 16777216.0;
    for (int direction = 0; direction < 20; ++direction) {
      double d[3];
      double length = 0;
      double stretch = 0;
      for (double& part : d) {
        part = random.between(-1000, 1000);
        length += part * part;
      }
      for_entries([&](int j, int k) { stretch += d[j] * square[j][k] * d[k]; });
      REQUIRE(std::abs(stretch) <= (defect + 1e-12) * length);
    }
  };
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Rotation coarse = rotation_of(any_quaternion(random));
    for_entries([&](int i, int j) { coarse.entry[i][j] &= round % 2 == 0 ? ~0x3FFF : ~0; });
    const Pose link = Pose::rigid(coarse.entry, kNowhere);
    REQUIRE(link.status() == Status::done);
    check(link);
    const Pose fine = Pose::rigid(rotation_of(any_quaternion(random)).entry, kNowhere);
    check(Pose::composed(fine, link));
    check(Pose::composed(link, fine));
    check(Pose::relative(fine, link));
    check(Pose::relative(link, fine));
    Pose chain = link;
    for (int joint = 0; joint < 12 && chain.status() == Status::done; ++joint) {
      check(chain.inverse());
      check(Pose::relative(link, chain));
      check(chain);
      chain =
          Pose::composed(chain, Pose::rigid(rotation_of(any_quaternion(random)).entry, kNowhere));
    }
    REQUIRE(chain.status() == Status::done);
  }
}

TEST_CASE("a chain of rotations is refused only if it is none, however long it is") {
  Random random = test_random(8);
  Pose chain = Pose::translated(0, 0, 0);
  for (int joint = 0; joint < 3000; ++joint) {
    chain = Pose::composed(chain, Pose::rigid(rotation_of(any_quaternion(random)).entry, kNowhere));
    REQUIRE(chain.status() == Status::done);
  }
  // The actual defect, not the sum of all bounds, which exceeds 50,000.
  CHECK(chain.matrix().defect < 4096);
}
