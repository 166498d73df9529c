// MoveIt's joint_limits.yaml narrows a URDF's limits.
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

namespace {

const std::string kJoints =
    link_texts("abcde") + joint_text("turn", "revolute", "a", "b", kLimit) +
    joint_text("spin", "continuous", "b", "c") +
    joint_text("copy", "revolute", "c", "d", kLimit + "<mimic joint=\"turn\" multiplier=\"-2\"/>") +
    joint_text("weld", "fixed", "d", "e");

tool::Model narrowed(RobotFiles& files, const std::string& yaml) {
  files.write("arm.urdf", "<robot name=\"arm\">\n" + kJoints + "</robot>\n");
  files.write("l.yaml", yaml);
  return tool::read_urdf(files.path("arm.urdf"), {}, "", files.warnings, files.path("l.yaml"));
}

std::string refused_limits(const std::string& yaml) {
  RobotFiles files;
  const std::string text = refusal_of([&] { return narrowed(files, yaml); });
  const std::size_t at = text.find("l.yaml");
  return at == std::string::npos ? text : text.substr(at);
}

}  // namespace

TEST_CASE("limits narrow, and mimics follow") {
  RobotFiles files;
  const tool::Model model = narrowed(files,
                                     "joint_limits:\n  turn:\n    min_position: -0.5\n"
                                     "    max_position: 2.00001\n    max_velocity: fast\n"
                                     "other: [1, 2]\n");
  CHECK(model.joints[0].lower == -0.5);
  CHECK(model.joints[0].upper == 2);
  CHECK(model.joints[2].lower == -4);
  CHECK(model.joints[2].upper == 1);
  CHECK(files.warnings.all().size() == 1);  // for the mimic's own limits
  RobotFiles others;
  const tool::Model upper = narrowed(others, "joint_limits: {turn: {max_position: 1.5}}");
  CHECK(upper.joints[0].lower == -1);
  CHECK(upper.joints[0].upper == 1.5);
}

TEST_CASE("limits that are not meant do not count") {
  RobotFiles files;
  const tool::Model model = narrowed(
      files, "joint_limits: {turn: {has_position_limits: false, max_position: 9}, gone: {a: 1}}");
  CHECK(model.joints[0].upper == 2);
  const std::size_t before = files.warnings.all().size();
  (void)narrowed(files,
                 "joint_limits:\n  gone: {min_position: 0}\n  spin: {max_position: 1}\n"
                 "  copy: {max_position: 1}\n  weld: {max_position: 1}\n");
  const auto& all = files.warnings.all();
  REQUIRE(all.size() == 2 * before + 4);
  CHECK(all[before].what == "limits 'gone', which is no joint of the robot; left out");
  CHECK(all[before].place == files.path("l.yaml") + ":2");
  CHECK(all[before + 1].what.find("'spin', which is continuous") != std::string::npos);
  CHECK(all[before + 2].what.find("'copy', which mimics another joint") != std::string::npos);
  CHECK(all[before + 3].what.find("'weld', which is fixed") != std::string::npos);
}

TEST_CASE("limits that widen, or are none, are refused with their line") {
  const std::string turn = "joint_limits:\n  turn:\n    ";
  CHECK(
      refused_limits(turn + "min_position: -1.001")
          .find(
              "l.yaml:3: gives 'turn' a min_position of -1.001, below the robot's limit of -1, and "
              "may only narrow it; give at least -1, or change the <limit> in ") == 0);
  CHECK(refused_limits(turn + "max_position: 2.001").find("at most 2, or") != std::string::npos);
  CHECK(refused_limits(turn + "max_position: deg(30)") ==
        "l.yaml:3: has a max_position that is no number, 'deg(30)'; give radians or metres");
  CHECK(refused_limits(turn + "max_position: !degrees 1").find("l.yaml:3: has a max_p") == 0);
  CHECK(refused_limits(turn + "max_position: .inf").find("is no number") != std::string::npos);
  CHECK(refused_limits(turn + "max_position: [1]") ==
        "l.yaml:3: has a max_position that is no number; give radians or metres");
  CHECK(refused_limits(turn + "{min_position: 1.5, max_position: 0}") ==
        "l.yaml:3: leaves 'turn' no value: from 1.5 to 0; correct them");
  CHECK(refused_limits(turn + "{max_position: 1, has_position_limits: maybe}") ==
        "l.yaml:3: has a has_position_limits that is neither true nor false");
  CHECK(refused_limits("joint_limits:\n  turn: 1\n") ==
        "l.yaml:2: 'turn' has no names and values; indent them below it");
  CHECK(refused_limits("joint_limits:\n").find("'joint_limits' has no names") != std::string::npos);
  CHECK(refused_limits("limits: {}\n") ==
        "l.yaml: has no `joint_limits:`; name MoveIt's joint_limits.yaml");
  CHECK(refused_limits("joint_limits:\n  turn: {\n").find("l.yaml:3: is no YAML: ") == 0);
  CHECK(refused_limits("a: b: c\n").find("l.yaml:1: is no YAML: ") == 0);
  CHECK(refused_limits(std::string(100000, '[')).find("is no YAML") != std::string::npos);
}
