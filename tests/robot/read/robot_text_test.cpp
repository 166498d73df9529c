// A robot passes from one process to another unchanged, or not at all.
#include "robot/read/robot_text.hpp"
#include "support/test.hpp"

namespace {

tool::ReadRobot any_robot() {
  using Shape = tool::UrdfGeometry::Shape;
  tool::ReadRobot read;
  read.robot.name = "two\tlines\n";
  read.robot.files = {"a b.stl"};
  read.warnings = {{"x.xml, joint 'j'", "is odd"}};
  read.robot.links.resize(2);
  read.robot.links[0].name = "base link";
  tool::UrdfCollision capsule;
  capsule.geometry.shape = Shape::capsule;
  capsule.geometry.radius = 0.1;
  capsule.geometry.length = 1e-300;
  tool::UrdfCollision mesh;
  mesh.origin.translation = {1, -2, 1.0 / 3};
  mesh.geometry.shape = Shape::triangles;
  mesh.geometry.precision = 1e-9;
  mesh.geometry.triangles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  read.robot.links[0].collisions = {capsule, mesh};
  read.robot.links[1].visuals = {capsule};
  tool::UrdfJoint& joint = read.robot.joints.emplace_back();
  joint.name = "j";
  joint.type = tool::UrdfJoint::Type::prismatic;
  joint.child = 1;
  joint.anchor = {0, 0, 0.7};
  joint.upper = 0.1;
  joint.mimic = {"j", 2, 3};
  return read;
}

}  // namespace

TEST_CASE("a robot survives as text") {
  const std::string text = tool::text_of(any_robot());
  const std::optional<tool::ReadRobot> read = tool::robot_of_text(text);
  REQUIRE(read);
  CHECK(tool::text_of(*read) == text);
  CHECK(read->robot.name == "two lines");
  CHECK(read->warnings[0].what == "is odd");
  CHECK(read->robot.links[1].has_visual);
  CHECK(read->robot.links[0].collisions[1].origin.translation[2] == 1.0 / 3);
  CHECK(read->robot.links[0].collisions[1].geometry.triangles.triangles.size() == 1);
  CHECK(read->robot.joints[0].mimic->offset == 3);
}

TEST_CASE("a refusal is the whole text") {
  tool::ReadRobot refused = any_robot();
  refused.refusal = "x.xml: is odd";
  CHECK(tool::text_of(refused) == "refusal\tx.xml: is odd\nend\n");
  CHECK(tool::robot_of_text(tool::text_of(refused))->refusal == "x.xml: is odd");
}

TEST_CASE("a text that is cut or changed is a robot or none") {
  const std::string text = tool::text_of(any_robot());
  for (std::size_t size = 0; size < text.size(); ++size) {
    CHECK(!tool::robot_of_text(text.substr(0, size)));
  }
  for (const char* const wrong :
       {"end\n", "robot\tr\t0\nend\n", "robot\tr\t1\nlink\ta\nend\n", "link\ta\nvertex\t0\t0\t0\n",
        "link\ta\nmimic\tj\t1\t0\n", "robot\tr\t0\nlink\ta\tb\nend\n", "odd\n"}) {
    CHECK(!tool::robot_of_text(wrong));
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = '9';
    if (const std::optional<tool::ReadRobot> read = tool::robot_of_text(changed)) {
      CHECK(read->robot.root < read->robot.links.size());
      for (const tool::UrdfJoint& joint : read->robot.joints) {
        CHECK(std::max(joint.parent, joint.child) < read->robot.links.size());
      }
    }
  }
}
