// What can't be read is refused with the file, the element and the mend.
#include <catch2/catch.hpp>

#include "support/arms/robot_files.hpp"

using namespace flashbvh;
using namespace flashbvh::test;
using Catch::Matchers::Contains;

namespace {

const std::string kTwoLinks = link_text("a") + link_text("b");

/// Of a robot of two links and this joint between.
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

std::string said_of_file(const std::string& text) {
  RobotFiles files;
  files.write("x.urdf", text);
  try {
    (void)tool::read_urdf(files.path("x.urdf"), {}, "", files.warnings);
    return {};
  } catch (const tool::UserError& error) {
    const std::string what = error.what();
    return what.substr(what.find("x.urdf"));
  }
}

}  // namespace

TEST_CASE("files that are no URDF") {
  tool::Warnings warnings;
  CHECK(said_of_file("<robot name=\"r\"><link name=\"a\">") ==
        "x.urdf: is no XML: Error reading Element value; mend it there");
  CHECK_THAT(said_of_file("hello"), Contains("x.urdf: is no XML"));
  CHECK_THAT(said_of_file("<robot name=\"r\">\n<link name=\"a\"></lin></robot>"),
             Contains("x.urdf:2: is no XML"));
  CHECK_THAT(said_of_file("<arm/>"), Contains("begins with <arm>, not with <robot>"));
  CHECK_THAT(said_of_file("<sdf/>"),
             Contains("is a model of Gazebo (SDF") && Contains("convert it"));
  CHECK_THAT(said_of_file("<mujoco model=\"a\"/>"),
             Contains("is a model of MuJoCo (MJCF), not a URDF") && Contains("convert it"));
  for (const char* const name : {"x.step", "x.STL"}) {
    CHECK_THROWS_WITH(tool::read_urdf(name, {}, "", warnings),
                      Contains("is a mesh or a model of CAD, which has no joints; name a URDF"));
  }
  CHECK_THAT(said_of_file(std::string("<robot\0>", 8)), Contains("is no text"));
  CHECK_THAT(said_of_file("<robot name=\"r\"><xacro:arm/></robot>"),
             Contains("is a xacro (it has <xacro:arm>)"));
  CHECK_THAT(said_of_file("<robot><link name=\"a\"/></robot>"), Contains("No name given"));
  CHECK_THAT(said_of_file("<robot name=\"r\"></robot>"), Contains("No link elements"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) {
    deep += "<a>";
  }
  CHECK_THAT(said_of_file(deep), Contains("nests elements over 1000 deep"));
  CHECK_THROWS_AS(tool::read_urdf("no such file", {}, "", warnings), tool::UserError);
}

TEST_CASE("joints that firmware can't hold, and what is missing of them") {
  CHECK(said_of_joint("revolute", kLimit) == "");
  CHECK(said_of_joint("floating", "") ==
        "arm.urdf, joint 'j': is floating, which firmware does not move; make it fixed, or write "
        "it as prismatic and revolute joints with links without geometry between");
  CHECK_THAT(said_of_joint("planar", ""), Contains("joint 'j': is planar"));
  CHECK_THAT(said_of_joint("ball", ""), Contains("joint 'j': is of type 'ball'; use revolute"));
  CHECK(said_of_joint("revolute", "") ==
        "arm.urdf, joint 'j': is revolute without limits; give it <limit lower=\"...\" "
        "upper=\"...\">, or make it continuous");
  CHECK(said_of_joint("prismatic", "<limit effort=\"1\" velocity=\"1\"/>") ==
        "arm.urdf, joint 'j': is prismatic without limits; give it <limit lower=\"...\" "
        "upper=\"...\">");
  CHECK(said_of_joint("revolute", "<limit lower=\"2\" upper=\"1\"/>") ==
        "arm.urdf, joint 'j': has a lower limit of 2 above its upper of 1; exchange them");
  CHECK(said_of_joint("revolute", "<limit lower=\"-180\" upper=\"90\"/>") ==
        "arm.urdf, joint 'j': has limits of four turns or more, -180 to 90 rad; if these are "
        "degrees, write -3.14159 and 1.5708; if it turns without end, make it continuous");
  CHECK_THAT(said_of_joint("revolute", "<limit lower=\"0\" upper=\"25.2\"/>"),
             Contains("has limits of four turns or more"));
  CHECK(said_of_joint("revolute", "<limit lower=\"-25.1\" upper=\"25.1\"/>") == "");
  CHECK_THAT(said_of_joint("revolute", "<limit lower=\"nan\" upper=\"1\"/>"), Contains("nan"));
  CHECK_THAT(said_of_joint("revolute", "<limit lower=\"-1e999\" upper=\"1\"/>"),
             Contains("-1e999"));
  CHECK(said_of_joint("continuous", "<axis xyz=\"0 0 0\"/>") ==
        "arm.urdf, joint 'j': moves along an axis of length 0, which has no direction; give its "
        "<axis> as in xyz=\"0 0 1\"");
  CHECK_THAT(said_of_joint("continuous", "<axis xyz=\"0 0\"/>"),
             Contains("axis element for joint [j]"));
  CHECK_THAT(said_of_joint("continuous", "<origin xyz=\"0 inf 0\"/>"), Contains("[inf]"));
}

TEST_CASE("mimics of nothing, of each other, and of what they can't follow") {
  RobotFiles files;
  const auto said = [&](const std::string& type, const std::string& first,
                        const std::string& second_type, const std::string& second) {
    return files.refusal(kTwoLinks + link_text("c") +
                         joint_text("j", type, "a", "b", kLimit + first) +
                         joint_text("k", second_type, "b", "c", kLimit + second));
  };
  const std::string follow_j = "<mimic joint=\"j\" multiplier=\"0.5\"/>";
  CHECK(said("revolute", "", "revolute", follow_j) == "");
  CHECK(said("revolute", "<mimic joint=\"gone\"/>", "revolute", "") ==
        "arm.urdf, joint 'j': mimics 'gone', which is no joint of the robot; name one that is");
  CHECK_THAT(said("revolute", "<mimic joint=\"k\"/>", "revolute", "<mimic joint=\"j\"/>"),
             Contains("mimics itself by way of others"));
  CHECK_THAT(said("revolute", "<mimic joint=\"j\"/>", "revolute", ""),
             Contains("joint 'j': mimics itself"));
  CHECK_THAT(said("fixed", "", "revolute", follow_j), Contains("'j', which is fixed"));
  CHECK_THAT(said("continuous", "", "revolute", follow_j), Contains("by a multiplier of 0.5"));
  CHECK_THAT(said("continuous", "", "prismatic", follow_j), Contains("slides with 'j'"));
  CHECK_THAT(said("revolute", "", "revolute", "<mimic joint=\"j\" multiplier=\"40\"/>"),
             Contains("joint 'k': is turned four times or more by 'j'"));
  CHECK_THAT(said("revolute", "", "revolute", "<mimic joint=\"j\" multiplier=\"1e300\"/>"),
             Contains("out of range"));
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
  CHECK_THAT(files.refusal(link_text("a") + link_text("a")), Contains("link 'a' is not unique"));
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
  CHECK(said_of_shape("<box size=\"1 2 3\"/>") == "");
  CHECK(said_of_shape("<box size=\"1 0 3\"/>") ==
        "arm.urdf, link 'a': has a box with an edge of 0; give a positive length");
  CHECK_THAT(said_of_shape("<sphere radius=\"-1\"/>"), Contains("a radius of -1"));
  CHECK_THAT(said_of_shape("<cylinder radius=\"1\" length=\"0\"/>"), Contains("length of 0"));
  CHECK_THAT(said_of_shape("<sphere radius=\"nan\"/>"), Contains("[nan]"));
  CHECK_THAT(said_of_shape("<sphere radius=\"1,5\"/>"), Contains("[1,5]"));
  CHECK_THAT(said_of_shape("<sphere/>"), Contains("Link [a]"));
  CHECK_THAT(said_of_shape("<capsule radius=\"1\" length=\"1\"/>"), Contains("has a <capsule>"));
  CHECK(said_of_shape("<drake:capsule/><sphere radius=\"1\"/><drake:hint/>") == "");
  CHECK_THAT(said_of_shape("<drake:capsule radius=\"1\"/>"),
             Contains("whose only shape, <drake:capsule>, is no URDF; use <box>"));
  CHECK_THAT(said_of_shape("<cone/>"), Contains("has a shape <cone>; use <box>"));
  CHECK_THAT(said_of_shape("<box size=\"1 1 1\"/><box size=\"1 1 1\"/>"),
             Contains("without one shape"));
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
        "URDF's folder");
  CHECK(said("filename=\"package://arm_meshes/a.stl\"") ==
        "arm.urdf, link 'a': the mesh 'package://arm_meshes/a.stl' is not beside the URDF nor "
        "above it; say where the package is by --package arm_meshes=DIR");
  files.packages["arm_meshes"] = files.path("there");
  CHECK_THAT(said("filename=\"package://arm_meshes/a.stl\""),
             Contains("is not there: no there/a.stl; give another --package arm_meshes=DIR"));
  CHECK_THAT(said("filename=\"http://host/a.stl\""), Contains("is not on this machine"));
  files.write("bad.stl", "no mesh");
  CHECK_THAT(said("filename=\"bad.stl\""), Contains("arm.urdf, link 'a': bad.stl:"));
  files.write("bad.step", "no mesh");
  CHECK_THAT(said("filename=\"bad.step\""), Contains("is a model of CAD"));
  CHECK_THAT(said("filename=\"bad.stl\" scale=\"1 0 1\""), Contains("with a scale of 0"));
  CHECK_THAT(said("scale=\"1 1 1\""), Contains("Link [a]"));
}
