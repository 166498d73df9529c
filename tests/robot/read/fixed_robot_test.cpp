// From a URDF to the firmware's data.
#include "robot/baked/fixed_robot.hpp"
#include "robot/baked/bake_links.hpp"
#include "support/arms/placed_links.hpp"
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

namespace {

constexpr double kPerRadian = kFullTurn / tool::kTurn;

struct Baked {
  std::vector<tool::BakedPart> wholes;
  std::vector<tool::BakedLink> links;
  std::unique_ptr<tool::FixedRobot> fixed;

  const Robot& robot() const { return fixed->robot(); }
};

Baked bake_robot(const tool::Model& model, std::optional<double> cell = {},
                 const std::vector<double>& deviations = {}) {
  tool::check_counts(model, "arm.urdf");
  const double chosen = tool::robot_cell(model, cell, "arm.urdf");
  Baked baked;
  std::vector<Mesh> meshes;
  for (const tool::ModelLink& link : model.links) {
    baked.links.push_back(tool::bake_link(link, chosen, 2, "arm.urdf"));
    baked.wholes.push_back(tool::bake_part(link.mesh, chosen));
  }
  for (const tool::BakedLink& link : baked.links) {
    meshes.push_back(link.view());
  }
  const std::vector<tool::WholeMesh> wholes = tool::views_of(baked.wholes);
  baked.fixed = std::make_unique<tool::FixedRobot>(
      model, wholes, meshes, chosen, std::vector<tool::GuardedPair>(), tool::Reaches(), deviations);
  return baked;
}

std::string limits(const std::string& lower, const std::string& upper) {
  return "<limit lower=\"" + lower + "\" upper=\"" + upper + "\"/>";
}

/// Whether a link's sphere holds a point, in cells.
bool holds(const RobotLink& sphere, const Vector3& p) {
  return std::hypot(p[0] * kFrameCell - sphere.centre[0], p[1] * kFrameCell - sphere.centre[1],
                    p[2] * kFrameCell - sphere.centre[2]) <= sphere.radius;
}

}  // namespace

TEST_CASE("limits are both allowed, and little more than them") {
  RobotFiles files;
  const tool::Model model =
      files.read(chain_text({{"revolute", limits("-6.283185307179586", "1.5")},
                             {"revolute", limits("-25.1", "25.1")},
                             {"continuous", ""}}));
  const Baked baked = bake_robot(model);
  const RobotJoint* const joints = baked.robot().joints;
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(joints[i].lower <= model.joints[i].lower * kPerRadian);
    CHECK(joints[i].upper >= model.joints[i].upper * kPerRadian);
    CHECK(joints[i].upper <= model.joints[i].upper * kPerRadian * (1 + 0x1p-21) + 1);
  }
  CHECK(joints[2].lower == 0);
  CHECK(joints[2].upper == 0);
}

TEST_CASE("mimics: firmware's multiplier, offset and limits") {
  RobotFiles files;
  const auto mimic = [](const std::string& multiplier, const std::string& offset) {
    return kLimit + "<mimic joint=\"j0\" multiplier=\"" + multiplier + "\" offset=\"" + offset +
           "\"/>";
  };
  const tool::Model model = files.read(chain_text({{"revolute", kLimit},
                                                   {"revolute", mimic("-1", "0")},
                                                   {"revolute", mimic("0.75", "0.5")},
                                                   {"prismatic", mimic("0.02", "0")},
                                                   {"revolute", mimic("0", "0")}}));
  const Baked baked = bake_robot(model, 1e-4);
  const RobotJoint* const joints = baked.robot().joints;
  CHECK(baked.robot().variable_count == 1);
  for (std::size_t i = 1; i < model.joints.size(); ++i) {
    const RobotJoint& joint = joints[i];
    const double units = joint.type == JointType::prismatic ? kFrameCell / 1e-4 : kPerRadian;
    const double factor = model.joints[i].multiplier * units / kPerRadian;
    for (const JointCoordinate value : {joints[0].lower, 0, 12345678, joints[0].upper}) {
      const double q = std::ldexp(1.0 * value * joint.multiplier, -joint.shift) + joint.offset;
      CHECK(q >= joint.lower - 0.5);
      CHECK(q <= joint.upper + 0.5);
      CHECK(std::fabs(q - (factor * value + model.joints[i].offset * units)) < 1.5);
    }
  }
}

TEST_CASE("a link's sphere holds what decides, and what firmware gets") {
  RobotFiles files;
  const tool::Model model =
      files.read(link_text("a") + link_text("b", "") + joint_text("j", "continuous", "a", "b"));
  constexpr double kCell = 1e-3;
  tool::ModelLink whole = model.links[0];
  tool::ModelLink coarse = model.links[0];
  whole.mesh.vertices[0] = {0.5, 0.01, 0.02};
  coarse.mesh.vertices[1] = {-0.01, -0.4, 0.03};
  const std::vector<tool::BakedPart> parts = {tool::bake_part(whole.mesh, kCell)};
  const tool::BakedLink link = tool::bake_link(coarse, kCell, 2, "arm.urdf");
  const auto sphere_of = [&](const std::vector<Mesh>& meshes) {
    return tool::FixedRobot(model, tool::views_of(parts), meshes, kCell, {}).robot().links[0];
  };
  const auto rounded = [](const Vector3& v) {
    return Vector3{std::round(v[0] / kCell), std::round(v[1] / kCell), std::round(v[2] / kCell)};
  };
  for (const Vector3& vertex : whole.mesh.vertices) {
    CHECK(holds(sphere_of({link.view()}), rounded(vertex)));
    CHECK(holds(sphere_of({}), rounded(vertex)));
  }
  for (const Vector3& vertex : coarse.mesh.vertices) {
    CHECK(holds(sphere_of({link.view()}), rounded(vertex)));
  }
  CHECK_FALSE(holds(sphere_of({}), rounded(coarse.mesh.vertices[1])));
}

TEST_CASE("the cell is the finest that all meshes and all frames fit") {
  RobotFiles files;
  const auto arm = [](const std::string& length) {
    return chain_text({{"revolute", kLimit + "<origin xyz=\"" + length + " 0 0\"/>"}});
  };
  const tool::Model small = files.read(arm("0.1"));
  const double for_meshes = tool::robot_cell(small, {}, "arm.urdf");
  CHECK(for_meshes == Approx(2 * 0.1018 / 32767).epsilon(0.02));
  const tool::Model large = files.read(arm("1000"));
  const double for_frames = tool::robot_cell(large, {}, "arm.urdf");
  CHECK(for_frames == Approx(1000.1 / (1 << 19)).epsilon(0.001));
  CHECK(bake_robot(large).robot().joints[0].fixed.translation[0] < kMaxFrameTranslation);
  CHECK_THAT(refusal_of([&] { bake_robot(large, for_frames / 2); }),
             Catch::Matchers::Contains("too far for frames in cells of"));
  CHECK_THAT(refusal_of([&] { bake_robot(files.read(arm("3e307"))); }),
             Catch::Matchers::Contains("reaches over 3.4e38 m far"));
  CHECK_THAT(refusal_of([&] { bake_robot(small, for_meshes / 2); }),
             Catch::Matchers::Contains("arm.urdf, link 'a': is too large for a cell of"));
}

TEST_CASE("robots that firmware can't hold") {
  RobotFiles files;
  std::string joints;
  std::string bare = link_text("l0");
  for (std::size_t i = 0; i <= kMaxJoints; ++i) {
    bare += link_text("l" + std::to_string(i + 1), "");
    joints += joint_text("j" + std::to_string(i), "continuous", "l" + std::to_string(i),
                         "l" + std::to_string(i + 1));
  }
  CHECK(refusal_of([&] { bake_robot(files.read(bare + joints)); }) ==
        "arm.urdf: has 65 moving joints, firmware holds 64; make those fixed that matter least, or "
        "bake it in parts");
  std::string links = link_text("l0");
  for (std::size_t i = 1; i <= kMaxLinks; ++i) {
    links += link_text("l" + std::to_string(i)) +
             joint_text("j" + std::to_string(i), "fixed", "l0", "l" + std::to_string(i));
  }
  CHECK_THAT(refusal_of([&] { bake_robot(files.read(links)); }),
             Catch::Matchers::Contains("has 256 links with a <collision>, firmware holds 255"));
  CHECK(refusal_of([&] { bake_robot(files.read(link_text("l0"))); }) ==
        "arm.urdf: has no joint that moves, so there is nothing to guard; give it one, or bake its "
        "links' meshes by `flashbvh bake`");
  files.write("many.obj", [] {
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 65536; ++i) {
      text += "f 1 2 3\n";
    }
    return text;
  }());
  const tool::Model many = files.read(
      link_text("a", "<collision><geometry><mesh filename=\"many.obj\"/></geometry></collision>") +
      link_text("b", "") + joint_text("j", "continuous", "a", "b"));
  CHECK_THAT(refusal_of([&] { bake_robot(many); }),
             Catch::Matchers::StartsWith("arm.urdf, link 'a': 65536 triangles, but 16-bit indices "
                                         "reach 65535; use --simplify"));
}

TEST_CASE("the slack grows by what the reader of a link's file rounded, along three axes, twice") {
  RobotFiles files;
  const double cell = 1e-4;
  tool::Model model = files.read(chain_text({{"revolute", limits("-1", "1")}}));
  const auto slack = [&] { return bake_robot(model, cell).robot().slack; };
  const double before = tool::link_deviation(model.links[1], cell);
  const std::uint32_t least = slack();
  model.links[1].precision = 10 * cell;
  CHECK(tool::link_deviation(model.links[1], cell) == Approx(before + std::sqrt(3.0) * 10 * cell));
  CHECK(bake_link(model.links[1], cell, 2, "").view().deviation_sixteenths >= 17 * 16);
  CHECK(slack() >= least + 2 * 17 * 256);
  CHECK(slack() <= least + 2 * 18 * 256);
}

TEST_CASE("links that deviate by more than a guard's slack holds are refused") {
  RobotFiles files;
  const tool::Model model = files.read(chain_text({{"revolute", limits("-1", "1")}}));
  constexpr double kCell = 1.0 / 1024;
  const double most = kMaxGuardDistance * kCell / (2 * kFineOne);
  const auto slack_of = [&](double deviation) {
    return bake_robot(model, kCell, {deviation, 0}).robot().slack;
  };
  CHECK(slack_of(0.9 * most) <= kMaxGuardDistance);
  for (const double more : {0.9999999, 1.01, 1e30}) {
    CHECK_THROWS_WITH(slack_of(more * most), Catch::Matchers::Contains("too early, more than"));
  }
}
