// An SRDF's lines by the decisions on their pairs, some of which are missing.
#include "robot/audit/audit.hpp"

#include "robot/read/urdf.hpp"
#include "support/arms/arms.hpp"
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// A post, and a blade that a joint turns into the post at one end of its range.
Model post_and_blade() {
  Model model;
  add_link(model, kNoJoint, box({0.05, -0.01, 0}, {0.07, 0.01, 0.1}));
  const std::size_t spin = add_joint(model, kNoJoint, Transform(), JointType::revolute, 0, 1.5);
  add_link(model, spin, box({-0.01, 0.03, 0}, {0.01, 0.1, 0.1}));
  model.neighbours = {{0, 1}};
  for (ModelLink& link : model.links) {
    link.sources = {link.name};
    link.source_begins = {0};
  }
  model.joints[spin].lower = -1.5;
  return model;
}

}  // namespace

TEST_CASE("a collision that may lie in a zone that there was no time for refutes no line") {
  Prepared robot = {post_and_blade(), 1e-3, {}, {}};
  for (const ModelLink& link : robot.model.links) {
    robot.wholes.push_back(bake_part(link.mesh, robot.cell));
  }
  Warnings warnings;
  Decided decided = decide(
      robot, {}, 0, "", [](const std::string&, double) {}, warnings);
  REQUIRE(decided.pairs[0].verdict == MatrixVerdict::can);
  const std::vector<DisabledPair> disabled = {{0, 1, "", 0}};
  CHECK(audit_of(robot, decided, disabled).lines[0].verdict == LineVerdict::refuted);
  decided.late_joints = {0};
  const Audit audit = audit_of(robot, decided, disabled);
  CHECK(audit.lines[0].verdict == LineVerdict::undecided);
  CHECK(audit.lines[0].why == "no time was left to find a zone about joint0");
}

TEST_CASE("an SRDF that is written reads as the same pairs, whatever the links' names") {
  RobotFiles files;
  const std::string odd = "d &lt;&amp;&quot;";
  const std::string robot = link_texts("abc") + link_text(odd) +
                            joint_text("j", "fixed", "a", "b") +
                            joint_text("k", "fixed", "a", "c") + joint_text("l", "fixed", "a", odd);
  const Model model = files.read(robot);
  files.write("x.srdf", srdf_of(model, {{0, 3, "Never"}, {1, 2, "Adjacent"}}));
  const std::vector<DisabledPair> read = read_srdf(files.path("x.srdf"), model, files.warnings);
  REQUIRE(read.size() == 2);
  CHECK((read[0].a == 0 && read[0].b == 3 && read[0].reason == "Never"));
  CHECK((read[1].a == 1 && read[1].b == 2 && read[1].reason == "Adjacent"));
  CHECK(files.warnings.all().empty());
}
