// Kinematics in fixed point against long doubles, and against the host program's doubles.
#include "lattice/sine.hpp"
#include "support/arms/fixed_arm.hpp"
#include "support/oracles/float_distance.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// The larger of both errors, in 2^-30.
long double sine_error(std::uint32_t turn) {
  const detail::SineCosine at = detail::sine_cosine(turn);
  const long double angle = std::ldexp(2 * std::acos(-1.0L) * turn, -32);
  return std::max(std::fabs(at.sine - std::sin(angle) * kRotationOne),
                  std::fabs(at.cosine - std::cos(angle) * kRotationOne));
}

/// A transform in metres, in cells.
Transform in_cells(Transform transform, double cell) {
  for (double& coordinate : transform.translation) {
    coordinate /= cell;
  }
  return transform;
}

/// The distance between the places to which two transforms move a point.
double apart(const Transform& t, const Transform& u, const Vector3& p) {
  return std::sqrt(squared(minus(placed(t, p), placed(u, p))));
}

/// The largest errors seen, as parts of the allowed ones.
struct Worst {
  double frame = 0;
  double pose = 0;
};

/// `kinematics`: the allowed error of one link, in cells.
void look(const FixedArm& arm, const Values& values, double kinematics, Worst& worst) {
  const Robot& robot = arm.robot();
  const Values coordinates = coordinates_of(robot, values);
  REQUIRE_FALSE(coordinates.empty());
  const PlacedLinks links(robot, coordinates);
  const std::vector<double> variables = arm.variables(values);
  const std::vector<Transform> exact = frames_of(arm.model, variables);
  for (std::uint8_t b = 0; b < robot.link_count; ++b) {
    const std::vector<Vector3> points = vertices_of(robot.meshes[b]);
    const Transform frame = transform_of(links.frame_of(b));
    const std::uint8_t joint = robot.links[b].joint;
    const Transform truth = joint == kBase ? frame : in_cells(exact[joint], arm.arm.cell());
    for (const Vector3& p : points) {
      worst.frame = std::max(worst.frame, apart(frame, truth, p) / kinematics);
    }
    for (std::uint8_t a = 0; a < b; ++a) {
      const Pose pose = links.pose(a, b);
      REQUIRE(pose.status() == Status::done);
      const Transform between = in_cells(
          frame_between(arm.model, joints_between(arm.model, a, b), variables), arm.arm.cell());
      for (const Vector3& p : points) {
        // A pose rounds its entries to 2^-22.
        const double rounding =
            std::sqrt(3) * ((std::fabs(p[0]) + std::fabs(p[1]) + std::fabs(p[2])) * 0x1p-23);
        const double off = apart(transform_of(pose), between, p);
        worst.pose = std::max(worst.pose, (off - rounding) / (2 * kinematics));
      }
    }
  }
}

/// The model with vertices on lattice points: its slack is that of placing and of kinematics.
Model on_lattice(Model model, double cell) {
  for (ModelLink& link : model.links) {
    for (Vector3& vertex : link.mesh.vertices) {
      for (double& coordinate : vertex) {
        coordinate = std::round(coordinate / cell) * cell;
      }
    }
  }
  return model;
}

}  // namespace

// FLASHBVH_SINES=1 tests all 2^32 angles.
TEST_CASE("sine and cosine are within 2^-29, and exact for whole quarters") {
  const long stride = number_in("FLASHBVH_SINES", 49'999);
  long double worst = 0;
  for (std::uint64_t turn = 0; turn < (std::uint64_t{1} << 32);
       turn += static_cast<std::uint64_t>(stride)) {
    worst = std::max(worst, sine_error(static_cast<std::uint32_t>(turn)));
  }
  for (std::uint32_t edge = 0; edge < 8; ++edge) {
    for (std::uint32_t off = 0; off < 2000; ++off) {
      worst = std::max(worst, sine_error((edge << 29) + off));
      worst = std::max(worst, sine_error((edge << 29) - off));
    }
  }
  CAPTURE(worst);
  CHECK(worst <= 2);
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    CHECK(sine_error(quarter << 30) < 0x1p-20L);  // exact, but for the sine of pi in long double
  }
}

TEST_CASE("frames and relative poses are no further off than the slack has it") {
  Worst worst;
  for_rounds(12, [&](Random& random, int round) {
    const double cell = round % 2 == 0 ? 1.2e-5 : 1e-3;
    const FixedArm arm(on_lattice(any_arm(random, 1 + random.below(8)), cell), cell);
    const double kinematics = (arm.robot().slack / 256.0 - kPlacing) / 2;
    for (int i = 0; i < 20; ++i) {
      look(arm, arm.any_values(random), kinematics, worst);
    }
  });
  CAPTURE(worst.frame, worst.pose);
  CHECK(worst.frame <= 1);
  CHECK(worst.pose <= 1);
  CHECK(worst.pose > 0.02);  // the test measures an error at all
}

TEST_CASE("limits are allowed, what lies beyond is not") {
  for_rounds(12, [&](Random& random, int) {
    const FixedArm arm(any_arm(random, 4), 1e-3);
    const Values inside = arm.any_values(random);
    std::vector<JointCoordinate> coordinates(arm.robot().joint_count);
    const auto status_with = [&](std::size_t variable, JointCoordinate value) {
      Values values = inside;
      values[variable] = value;
      return set_coordinates(arm.robot(), values.data(), coordinates.data());
    };
    for (std::size_t i = 0; i < inside.size(); ++i) {
      CHECK(status_with(i, kNoCoordinate) == Status::not_a_coordinate);
      const RobotJoint& joint = arm.joint_of(i);
      if (arm.is_free(i)) {
        CHECK(status_with(i, INT32_MAX) == Status::done);
        CHECK(status_with(i, -INT32_MAX) == Status::done);
        continue;
      }
      CHECK(status_with(i, joint.lower) == Status::done);
      CHECK(status_with(i, joint.upper) == Status::done);
      CHECK(status_with(i, joint.lower - 1) == Status::joint_out_of_limits);
      CHECK(status_with(i, joint.upper + 1) == Status::joint_out_of_limits);
      CHECK(status_with(i, INT32_MAX) == Status::joint_out_of_limits);
    }
  });
}

TEST_CASE("turns make no difference to joints without limits, nor to what mimics them") {
  Model model;
  const std::size_t free = add_joint(model, kNoJoint, {}, JointType::continuous, -kPi, kPi);
  add_mimic(model, free, shifted({0.1, 0, 0}), JointType::continuous, 0, 25, 0.5);
  add_link(model, 1, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 1e-4);
  for (const JointCoordinate at : {0, 1, -1, kFullTurn / 3, -kFullTurn / 2}) {
    JointCoordinate wanted[2];
    REQUIRE(set_coordinates(arm.robot(), &at, wanted) == Status::done);
    CHECK(wanted[0] == at);
    const double mimicked = 25.0 * at / kFullTurn + 0.5 / (2 * kPi) - 1.0 * wanted[1] / kFullTurn;
    CHECK(std::fabs(mimicked - std::round(mimicked)) < 4.0 / kFullTurn);
    for (const int turns : {-7, -1, 1, 7}) {
      JointCoordinate coordinates[2];
      const JointCoordinate value = at + turns * kFullTurn;
      REQUIRE(set_coordinates(arm.robot(), &value, coordinates) == Status::done);
      CHECK(coordinates[0] == wanted[0]);
      CHECK(coordinates[1] == wanted[1]);
    }
  }
}

TEST_CASE("frames at the ends of their range have sums and differences") {
  const auto along = [](std::int32_t x, std::int32_t y) {
    Frame frame = kIdentityFrame;
    frame.translation[0] = x;
    frame.translation[1] = y;
    return frame;
  };
  constexpr std::int32_t far = kMaxFrameTranslation;
  CHECK(composed(along(far, 0), along(far, -far)).translation[0] == INT32_MAX);
  CHECK(composed(along(0, -far), along(far, -far)).translation[1] == INT32_MIN);
  CHECK(composed(along(far, -far), along(far - 1, -far + 1)).translation[0] == INT32_MAX);
  CHECK(composed(along(far, -far), along(far - 1, -far)).translation[1] == INT32_MIN);
  CHECK(composed(along(far, 5), along(far - 2, 6)).translation[0] == INT32_MAX - 1);
  CHECK(composed(along(INT32_MAX, INT32_MIN), along(far, -far)).translation[1] == INT32_MIN);
  for (const std::int32_t sign : {1, -1}) {
    CHECK(relative_pose(along(-far * sign, 0), along((far - 1) * sign, 0)).status() ==
          Status::done);
    CHECK(relative_pose(along(0, -far), along(0, far)).status() ==
          Status::translation_out_of_range);
    CHECK(relative_pose(along(sign * INT32_MAX, 0), along(-sign * INT32_MAX, 0)).status() ==
          Status::translation_out_of_range);
  }
  CHECK(relative_pose(along(-far, 0), along(far, 0)).status() == Status::translation_out_of_range);
  // Turned by an eighth, the difference has a component beyond 32 bits.
  Frame eighth = along(-far, -far);
  const auto half = static_cast<std::int32_t>(std::lround(std::sqrt(0.5) * kRotationOne));
  eighth.rotation[0][0] = eighth.rotation[1][1] = eighth.rotation[1][0] = half;
  eighth.rotation[0][1] = -half;
  const Pose pose = relative_pose(eighth, along(far - 1, far - 1));
  REQUIRE(pose.status() == Status::done);
  const double cells = std::sqrt(2.0) * (2.0 * far - 1) / kFrameCell;
  CHECK(std::fabs(pose.translation(0) - cells) < 2);
  CHECK(std::abs(pose.translation(1)) <= 1);
}
