// Unreadable input is refused with the file, the element and the fix.
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

using Catch::Matchers::Contains;

namespace {

const std::string kTwoLinks = link_texts("ab");

/// The refusal of a robot of two links with this joint in between.
std::string said_of_joint(const std::string& type, const std::string& inside) {
  RobotFiles files;
  return files.refusal(kTwoLinks + joint_text("j", type, "a", "b", inside));
}

std::string said_of_link(const std::string& inside) {
  RobotFiles files;
  return files.refusal(link_text("a", inside));
}

std::string said_of_shape(const std::string& shape) {
  return said_of_link("<collision><geometry>" + shape + "</geometry></collision>");
}

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) {
    text += part;
  }
  return text;
}

std::string said_of_file(const std::string& text) {
  RobotFiles files;
  files.write("x.urdf", text);
  const std::string what =
      refusal_of([&] { return tool::read_urdf(files.path("x.urdf"), {}, "", files.warnings); });
  return what.substr(what.find("x.urdf"));
}

/// `wanted`: the whole message if it is empty or begins with the file, else a part.
void check_said(const std::string& said, const std::string& wanted) {
  const bool is_all = wanted.empty() || wanted.rfind("arm.urdf", 0) == 0;
  CHECK_THAT(said, Contains(wanted) && Catch::Matchers::StartsWith(is_all ? wanted : ""));
  CHECK((!is_all || said.size() == wanted.size()));
}

}  // namespace

TEST_CASE("files that are no URDF") {
  const auto [text, wanted] = GENERATE(table<std::string, const char*>({
      {"<robot name=\"r\">\n<link name=\"a\"></lin></robot>",
       "x.urdf:2: is no XML: mismatched tag in <'link'>; correct it there"},
      {"hello", "x.urdf:1: is no XML: syntax error; correct it there"},
      {"<arm/>", "begins with <arm>, not with <robot>; name another file"},
      {std::string("<robot\0>", 8), "is no text"},
      {"<mujoco/>", "is MJCF; convert it to a URDF"},
      {"<sdf version=\"1.9\"/>", "is SDF; convert it to a URDF"},
      {"<robot><link name=\"a\"/></robot>", "No name given"},
      {"<robot name=\"r\"></robot>", "No link elements"},
      {repeated("<a>", 1001), "nests elements over 1000 deep"},
  }));
  CHECK_THAT(said_of_file(text), Contains(wanted));
  tool::Warnings warnings;
  for (const char* const name : {"x.step", "x.STL"}) {
    CHECK_THROWS_WITH(tool::read_urdf(name, {}, "", warnings),
                      Contains("is a mesh or a model of CAD, which has no joints; name a URDF"));
  }
  CHECK_THROWS_AS(tool::read_urdf("no such file", {}, "", warnings), tool::UserError);
}

TEST_CASE("a xacro that is not expanded, as a URDF and as an SRDF") {
  const auto [inside, has] = GENERATE(table<const char*, const char*>({
      {"<xacro:include filename=\"a\"/>", "<xacro:include>"},
      {"\n<group name=\"g\"><xacro:if value=\"1\"/></group>", "<xacro:if>"},
      {"<include filename=\"a.xacro\"/>", "<include>"},
      {"<link name=\"${prefix}a\"/>", "${prefix}a"},
      {"<disable_collisions link1=\"a\" link2=\"$(arg side)_b\"/>", "$(arg side)_b"},
  }));
  const std::string text = "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\" name=\"arm\">" +
                           std::string(inside) + "</robot>";
  CHECK_THAT(said_of_file(text), Contains("is a xacro (it has " + std::string(has)));
  CHECK_THAT(said_of_file("<robot name=\"${n}\"/>"), Contains("is a xacro (it has ${n})"));
  RobotFiles files;
  files.write("arm.srdf", text);
  CHECK_THAT(
      refusal_of([&] {
        return files.read(kTwoLinks + joint_text("j", "fixed", "a", "b"), files.path("arm.srdf"));
      }),
      Contains("arm.srdf:" + std::string(inside[0] == '\n' ? "2" : "1") + ": is a xacro (it has " +
               has) &&
          Contains("write `xacro ") && Contains("arm.srdf > OUT.srdf`"));
}

TEST_CASE("joints that firmware can't hold, and what is missing of them") {
  const auto [type, inside, wanted] = GENERATE(table<const char*, const char*, const char*>({
      {"revolute", R"(<limit lower="-1" upper="2" effort="1" velocity="1"/>)", ""},
      {"revolute", R"(<limit lower="-25.1" upper="25.1"/>)", ""},
      {"floating", "",
       "arm.urdf, joint 'j': is floating, which firmware does not move; make it fixed, or write "
       "it as prismatic and revolute joints with links without geometry between"},
      {"ball", "", "joint 'j': is of type 'ball'; use revolute"},
      {"revolute", "",
       "arm.urdf, joint 'j': is revolute without limits; give it <limit lower=\"...\" "
       "upper=\"...\">, or make it continuous"},
      {"prismatic", R"(<limit effort="1" velocity="1"/>)",
       "arm.urdf, joint 'j': is prismatic without limits; give it <limit lower=\"...\" "
       "upper=\"...\">"},
      {"revolute", R"(<limit lower="2" upper="1"/>)",
       "arm.urdf, joint 'j': has a lower limit of 2 above its upper of 1; exchange them"},
      {"revolute", R"(<limit lower="-180" upper="90"/>)",
       "arm.urdf, joint 'j': has limits of four turns or more, -180 to 90 rad; if these are "
       "degrees, write -3.14159 and 1.5708; if it turns without end, make it continuous"},
      {"revolute", R"(<limit lower="nan" upper="1"/>)", "nan"},
      {"continuous", R"(<axis xyz="0 0 0"/>)",
       "arm.urdf, joint 'j': moves along an axis of length 0, which has no direction; give its "
       "<axis> as in xyz=\"0 0 1\""},
      {"continuous", R"(<axis xyz="0 0"/>)", "axis element for joint [j]"},
  }));
  check_said(said_of_joint(type, inside), wanted);
}

TEST_CASE("mimics of nothing, of each other, and of joints that they can't follow") {
  const auto [first, first_mimics, second, second_mimics, wanted] =
      GENERATE(table<const char*, const char*, const char*, const char*, const char*>({
          {"revolute", "", "revolute", R"(joint="j" multiplier="0.5")", ""},
          {"revolute", R"(joint="gone")", "revolute", "",
           "arm.urdf, joint 'j': mimics 'gone', which is no joint of the robot; name one that is"},
          {"revolute", R"(joint="k")", "revolute", R"(joint="j")",
           "mimics itself by way of others"},
          {"revolute", R"(joint="j")", "revolute", "", "joint 'j': mimics itself"},
          {"fixed", "", "revolute", R"(joint="j" multiplier="0.5")", "'j', which is fixed"},
          {"continuous", "", "revolute", R"(joint="j" multiplier="0.5")", "by a multiplier of 0.5"},
          {"continuous", "", "prismatic", R"(joint="j" multiplier="0.5")", "slides with 'j'"},
          {"revolute", "", "revolute", R"(joint="j" multiplier="40")",
           "joint 'k': is turned four times or more by 'j'"},
          {"revolute", "", "revolute", R"(joint="j" multiplier="1e300")", "out of range"},
      }));
  const auto mimic = [](const std::string& inside) {
    return inside.empty() ? kLimit : kLimit + "<mimic " + inside + "/>";
  };
  RobotFiles files;
  check_said(files.refusal(kTwoLinks + link_text("c") +
                           joint_text("j", first, "a", "b", mimic(first_mimics)) +
                           joint_text("k", second, "b", "c", mimic(second_mimics))),
             wanted);
}

TEST_CASE("graphs that are no tree") {
  RobotFiles files;
  CHECK_THAT(files.refusal(kTwoLinks), Contains("Two root links found"));
  CHECK_THAT(files.refusal(kTwoLinks + joint_text("j", "fixed", "a", "b") +
                           joint_text("k", "fixed", "b", "a")),
             Contains("hangs on a loop of joints"));
  CHECK_THAT(files.refusal(kTwoLinks + link_text("c") + joint_text("j", "fixed", "c", "b") +
                           joint_text("k", "fixed", "b", "c")),
             Contains("hangs on a loop of joints"));
  CHECK(files.refusal(kTwoLinks + link_text("c") + joint_text("j", "fixed", "a", "b") +
                      joint_text("l", "fixed", "a", "c") + joint_text("k", "fixed", "c", "b")) ==
        "arm.urdf, link 'b': is the child of two joints, 'j' and 'k'; a robot is a tree: leave one "
        "of them out");
  CHECK_THAT(files.refusal(link_text("a") + joint_text("j", "fixed", "a", "gone")),
             Contains("joint 'j': has the child 'gone', which is no link of the robot"));
  CHECK_THAT(files.refusal(link_texts("aa")), Contains("link 'a' is not unique"));
  CHECK_THAT(files.refusal(kTwoLinks + link_text("c") + joint_text("j", "fixed", "a", "b") +
                           joint_text("j", "fixed", "b", "c")),
             Contains("joint 'j' is not unique"));
}

TEST_CASE("what a robot says is no format of messages") {
  CHECK_THAT(said_of_shape("<box size=\"1 %s%n 3\"/>"), Contains("%s%n"));
  RobotFiles files;
  CHECK(files.refusal(link_text("a%n") + link_text("%%s") + link_text("c") +
                      joint_text("%n", "revolute", "a%n", "%%s", kLimit) +
                      joint_text("k", "revolute", "%%s", "c",
                                 kLimit + "<mimic joint=\"%n\" multiplier=\"0.5\"/>")) == "");
  CHECK_THAT(files.refusal(link_text("a",
                                     "<collision><geometry><mesh filename=\"50%n%%.stl\"/>"
                                     "</geometry></collision>")),
             Contains("no 50%n%%.stl;"));
}

TEST_CASE("shapes that are none") {
  const auto [shape, wanted] = GENERATE(table<const char*, const char*>({
      {R"(<box size="1 2 3"/>)", ""},
      {R"(<drake:capsule/><sphere radius="1"/><drake:hint/>)", ""},
      {R"(<box size="1 0 3"/>)",
       "arm.urdf, link 'a': has a box with an edge of 0; give a positive length"},
      {R"(<sphere radius="-1"/>)", "a radius of -1"},
      {R"(<cylinder radius="1" length="0"/>)", "length of 0"},
      {R"(<sphere radius="nan"/>)", "[nan]"},
      {R"(<capsule radius="1" length="1"/>)", "has a <capsule>"},
      {R"(<drake:capsule radius="1"/>)",
       "whose only shape, <drake:capsule>, is no URDF; use <box>"},
      {"<cone/>", "has a shape <cone>; use <box>"},
      {R"(<box size="1 1 1"/><box size="1 1 1"/>)", "without one shape"},
  }));
  check_said(said_of_shape(shape), wanted);
}

TEST_CASE("what URDF does not know of a pose, a size or a limit") {
  const auto [in_collision, in_geometry,
              wanted] = GENERATE(table<const char*, const char*, const char*>({
      {R"(<origin xyz="1 0 0" quat_xyzw="0 0 0 1"/>)", "",
       "arm.urdf, link 'a': has <origin quat_xyzw=\"0 0 0 1\">, which URDF does not know; its "
       "attributes are xyz, rpy"},
      {R"(<origin xyz="0 0 1" xyz="0 0 2"/>)", "", "is no XML"},
      {R"(<origin/><origin xyz="1 0 0"/>)", "",
       "arm.urdf, link 'a': has two <origin> in one <collision>; leave one of them out"},
      {"<origin>1 0 0</origin>", "", "has text in its <origin>"},
      {"<origin><xyz>1 0 0</xyz></origin>", "", "has <xyz> in <origin>"},
      {R"(<orgin xyz="1 0 0"/>)", "", "has <orgin> in <collision>, which URDF does not know"},
      {"", R"(<box size="1 1 1" scale="2 2 2"/>)", "<box scale=\"2 2 2\">"},
      {"", R"(<box size="1 1"/>)", "Link [a]"},
      {"", "<box><size>1 1 1</size></box>", "has <size> in <box>"},
      {"", R"(<mesh filename="a.stl" scal="0.001 0.001 0.001"/>)", "<mesh scal="},
      {"", R"(<mesh filename="a.stl" scale="0.001"/>)", "Link [a]"},
      {"", R"(<origin xyz="1 0 0"/><box size="1 1 1"/>)", "without one shape in its <geometry>"},
  }));
  const std::string shape = *in_geometry == 0 ? R"(<sphere radius="1"/>)" : in_geometry;
  check_said(said_of_link("<collision>" + std::string(in_collision) + "<geometry>" + shape +
                          "</geometry></collision>"),
             wanted);
}

TEST_CASE("shapes and places of a link that URDF does not read") {
  CHECK_THAT(
      said_of_link(kBall + "<colision><geometry><sphere radius=\"1\"/></geometry></colision>"),
      Contains("link 'a': has a shape in <colision>"));
  CHECK_THAT(said_of_link(kBall + "<geometry><sphere radius=\"1\"/></geometry>"),
             Contains("has a shape in <geometry>"));
  CHECK_THAT(said_of_link(kBall + R"(<origin xyz="1 0 0"/>)"),
             Contains("has an <origin> of its own"));
  CHECK(said_of_link(kBall + R"(<origin xyz="0 0 0" rpy="0 -0 0"/>)") == "");
}

TEST_CASE("what URDF does not know of a joint") {
  const auto [inside, wanted] = GENERATE(table<const char*, const char*>({
      {R"(<axis xzy="0 0 1"/>)",
       "arm.urdf, joint 'j': has <axis xzy=\"0 0 1\">, which URDF does not know; its attributes "
       "are xyz"},
      {R"(<axis xyz="0 0 1" rpy="0 0 1"/>)", "has <axis rpy=\"0 0 1\">"},
      {R"(<axis xyz="0 0 1" rpy="0 0 0"/>)", ""},
      {"<axis/>", "which has no direction"},
      {"<axis>0 0 1</axis>", "has text in its <axis>"},
      {R"(<axis xyz="0 0 1"/><axis xyz="1 0 0"/>)", "has two <axis> in one <joint>"},
      {R"(<parent link="b"/>)", "has two <parent> in one <joint>"},
      {R"(<mimic joint="k" multipler="2"/>)", "has <mimic multipler=\"2\">"},
      {R"(<safety_controller soft_lower_limt="0"/>)", "has <safety_controller soft_lower_limt="},
      {R"(<safety_controller soft_lower_limit="0 rad"/>)",
       "soft_lower_limit that is no number, '0 rad'"},
      {R"(<dynamics damping="?" springs="1"/><gazebo><axes/></gazebo><transmission/><my:axis xzy="1"/>)",
       ""},
  }));
  check_said(said_of_joint("revolute", kLimit + inside), wanted);
}

TEST_CASE("a misspelt limit, or one for another joint type") {
  CHECK_THAT(said_of_joint("revolute", R"(<limit lower="-1" uper="1"/>)"),
             Contains("has <limit uper=\"1\">"));
  CHECK_THAT(said_of_joint("revolute", R"(<limits lower="-1" upper="1"/>)"),
             Contains("has <limits> in <joint>"));
  CHECK_THAT(said_of_joint("fixed", R"(<orgin xyz="1 0 0"/>)"), Contains("has <orgin> in <joint>"));
  RobotFiles files;
  (void)files.read(kTwoLinks + joint_text("j", "revolute", "a", "b", R"(<limit lower="-1"/>)"));
  REQUIRE(files.warnings.all().size() == 1);
  CHECK(files.warnings.all()[0].what ==
        "has a <limit> without upper, which URDF takes for 0; write upper=\"0\" if that is meant");
}

TEST_CASE("links without a shape that collides") {
  CHECK_THAT(said_of_link("<collision/>"), Contains("link 'a': has a <collision> without one"));
  CHECK(said_of_link("<visual><geometry><box size=\"1 1 1\"/></geometry></visual>") ==
        "arm.urdf: has no link with a <collision>; give those that can collide one");
}

TEST_CASE("meshes that are not there or no meshes") {
  RobotFiles files;
  const auto said = [&](const std::string& mesh) {
    return files.refusal(
        link_text("a", "<collision><geometry><mesh " + mesh + "/></geometry></collision>"));
  };
  CHECK(said("filename=\"gone.stl\"") ==
        "arm.urdf, link 'a': the mesh 'gone.stl' is not there: no gone.stl; give its path from the "
        "robot's folder");
  CHECK(said("filename=\"package://arm_meshes/a.stl\"") ==
        "arm.urdf, link 'a': the mesh 'package://arm_meshes/a.stl' is not next to the robot's file "
        "nor above it; say where the package is by --package arm_meshes=DIR");
  files.packages["arm_meshes"] = files.path("there");
  CHECK_THAT(said("filename=\"package://arm_meshes/a.stl\""),
             Contains("is not there: no there/a.stl; give another --package arm_meshes=DIR"));
  CHECK_THAT(said("filename=\"http://host/a.stl\""), Contains("is not on this machine"));
  files.write("bad.stl", "no mesh");
  CHECK_THAT(said("filename=\"bad.stl\""), Contains("arm.urdf, link 'a': bad.stl:"));
  files.write("bad.step", "no mesh");
  CHECK_THAT(said("filename=\"bad.step\""), Contains("is no mesh by its extension"));
  CHECK_THAT(said("filename=\"bad.stl\" scale=\"1 0 1\""), Contains("with a scale of 0"));
  CHECK_THAT(said("scale=\"1 1 1\""), Contains("Link [a]"));
}
