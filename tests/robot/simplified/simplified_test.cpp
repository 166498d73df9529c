// A guard of simplified links, judged by the original links in doubles: it never reports a larger
// distance than promised, and stops no earlier than documented.
#include "robot/baked/bake_links.hpp"
#include "robot/matrix/joint_zone.hpp"
#include "simplify/zoo.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/oracles/drawn_mesh.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kStop = 0.006;
constexpr double kWarn = 0.02;

bake::SourceMesh scaled(bake::SourceMesh mesh, double by) {
  for (auto& vertex : mesh.vertices) {
    for (double& coordinate : vertex) {
      coordinate *= by;
    }
  }
  return mesh;
}

/// Two rings of some thousand triangles; the second swings through and about the first. A small,
/// separate box is a shell of its own.
Model two_rings() {
  Model model;
  add_link(model, kNoJoint, scaled(wavy_ring(44, 18, 0.5), 0.005));
  const std::size_t swing =
      add_joint(model, kNoJoint, shifted({0.29, 0, 0}), JointType::revolute, -3, 3);
  const std::size_t tilt =
      add_joint(model, swing, shifted({0.09, 0, 0}), JointType::continuous, -kPi, kPi);
  bake::SourceMesh ring = scaled(wavy_ring(36, 14, 0.3), 0.002);
  append(flashbvh::test::box({-0.14, -0.01, -0.01}, simplify::Point{0.02, 0.02, 0.02}, 6), ring);
  add_link(model, tilt, ring);
  return model;
}

struct SimplifiedArm {
  SimplifiedArm(Model made, double length) : model(std::move(made)) {
    cell = robot_cell(model, std::nullopt, "");
    std::vector<Mesh> meshes;
    std::vector<double> deviations;
    for (const ModelLink& link : model.links) {
      simplify::Coarsening coarse(link.mesh, cell);
      coarse.coarsen(length);
      wholes.push_back(bake_part(link_input(link, ""), cell, 2));
      links.push_back(bake_link(link, cell, 2, "", &coarse));
      deviations.push_back(links.back().deviation);
      drawn.emplace_back(triangles_of(link.mesh));
    }
    for (const BakedLink& link : links) {
      meshes.push_back(link.view());
    }
    fixed = std::make_unique<FixedRobot>(model, views_of(wholes), meshes, cell,
                                         std::vector<GuardedPair>{{0, 1, kStop, kWarn}}, Reaches(),
                                         deviations);
  }

  /// Whether the original links are nearer than that, in metres.
  bool are_nearer(const Values& values, double distance) const {
    std::vector<double> variables;
    for (const JointCoordinate value : values) {
      variables.push_back(value * tool::kTurn / kFullTurn);
    }
    return drawn[0].is_nearer(drawn[1], frames_of(model, variables).back(), distance);
  }

  Model model;
  double cell = 0;
  std::vector<BakedPart> wholes;
  std::vector<BakedLink> links;
  std::vector<DrawnMesh> drawn;
  std::unique_ptr<FixedRobot> fixed;
};

}  // namespace

TEST_CASE("a guard of simplified links holds what it says of all triangles") {
  for (const double length : {0.0003, 0.0015}) {
    const SimplifiedArm arm(two_rings(), length);
    const Robot& robot = arm.fixed->robot();
    CAPTURE(length, robot.slack, arm.links[0].triangles.size());
    REQUIRE(arm.links[0].triangles.size() < 1500);
    REQUIRE(robot.slack * arm.cell / kFineOne >= 2 * 0.9 * length);
    const int count = is_thorough() ? 100'000 : 120;
    int stops = 0;
    int passes = 0;
    for_rounds(count, 1, [&](Random& random, int) {
      // Most of the values bring the two near.
      Values values;
      do {
        values = {random.between(robot.joints[0].lower, robot.joints[0].upper),
                  random.between(-kFullTurn / 2, kFullTurn / 2)};
      } while (!arm.are_nearer(values, 0.02) && random.below(8) != 0);
      CAPTURE(values[0], values[1]);
      const auto state = std::make_unique<AnyGuardState>();
      Guard guard(robot, *state);
      REQUIRE(guard.prime(values.data()).status == Status::done);
      const GuardAnswer answer = guard.update(values.data(), 1'000'000);
      REQUIRE(answer.status == Status::done);
      REQUIRE(answer.verdict != Verdict::not_yet_known);
      CHECK_FALSE(arm.are_nearer(values, answer.distance * arm.cell / kFineOne));
      if (answer.verdict >= Verdict::leaving) {
        ++stops;
        CHECK(arm.are_nearer(values, kStop + 4 * length + 0.001));
      } else {
        ++passes;
        CHECK_FALSE(arm.are_nearer(values, kStop));
      }
    });
    CHECK(stops > count / 40);
    CHECK(passes > count / 40);
  }
}

TEST_CASE("zones of simplified links are cut as finely as others, or finer") {
  constexpr double kCell = 1e-4;
  Model model;
  add_link(model, kNoJoint, prism(24, 0.1, 0, 0, -0.3, 0.1));
  const std::size_t joint = add_joint(model, kNoJoint, {}, JointType::revolute, -1, 1);
  add_link(model, joint, prism(24, 0.11, 0, 0, -0.05, 0.3));
  model.neighbours = {{0, 1}};
  const BakedArm arm(model, kCell);
  std::vector<std::size_t> triangles;
  for (const double early : {0.0, 0.15}) {
    MatrixOptions options;
    options.early = early / kCell;
    const auto given = joint_zones(model, arm.wholes(), kCell, options, {{joint, 0.2}}).zones;
    REQUIRE(given.size() == 1);
    REQUIRE_FALSE(given[0].bodies.empty());
    triangles.push_back(given[0].bodies[0].mesh_a.triangles.size());
  }
  CHECK(triangles[1] >= triangles[0]);
}

TEST_CASE("drawn meshes measure triangles as points of them do") {
  for_rounds(300, 1, [](Random& random, int) {
    const auto any = [&](int most) {
      FloatTriangle triangle;
      for (Vector3& corner : triangle) {
        for (double& coordinate : corner) {
          coordinate = random.between(-most, most);
        }
      }
      return triangle;
    };
    const int most = random.below(2) == 0 ? 2 : 100;
    const FloatTriangle p = any(most);
    FloatTriangle q = any(most);
    for (Vector3& corner : q) {
      corner[2] += random.below(2) == 0 ? 0 : 1.5 * most;
    }
    const double distance = std::sqrt(squared_distance(p, q));
    double least = HUGE_VAL;
    constexpr int kSteps = 12;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vector3 on_edge = plus(p[0], double(i) / kSteps, minus(p[1], p[0]));
        const Vector3 at = plus(on_edge, double(j) / kSteps, minus(p[2], p[0]));
        least = std::min(least, std::sqrt(simplify::squared_distance(at, q)));
      }
    }
    CAPTURE(distance, least);
    CHECK(distance <= least + 1e-9);
    CHECK(distance >= least - 3.5 * most / kSteps);
    CHECK(distance == Approx(std::sqrt(squared_distance(q, p))).margin(1e-9));
    const DrawnMesh first({p});
    CHECK(first.is_nearer(DrawnMesh({q}), Transform(), distance + 1e-9));
    CHECK_FALSE(first.is_nearer(DrawnMesh({q}), Transform(), distance - 1e-9));
  });
}
