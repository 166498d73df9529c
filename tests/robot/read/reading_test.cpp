// Features of real URDFs, read as intended.
#include <locale>

#include "mesh/package.hpp"
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

namespace {

const std::string kTriangle = "v 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\n";

std::string mesh(const std::string& name, const std::string& scale = "") {
  return "<collision><geometry><mesh filename=\"" + name + "\"" +
         (scale.empty() ? "" : " scale=\"" + scale + "\"") + "/></geometry></collision>";
}

}  // namespace

TEST_CASE("fixed joints are folded, whatever else they carry") {
  RobotFiles files;
  const std::string odd =
      "<origin xyz=\"0 0 1\"/><axis xyz=\"0 0 0\"/><limit lower=\"5\"/>"
      "<mimic joint=\"gone\"/>";
  const tool::Model model =
      files.read(chain_text({{"fixed", odd}, {"revolute", "<origin xyz=\"0 2 0\"/>" + kLimit}}));
  REQUIRE(model.joints.size() == 1);
  CHECK(model.joints[0].name == "j1");
  CHECK(model.joints[0].fixed.translation == std::array<double, 3>{0, 2, 1});
  REQUIRE(model.links.size() == 3);
  CHECK(model.links[1].joint == tool::kNoJoint);
  CHECK(model.links[2].joint == 0);
  CHECK(model.neighbours ==
        std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {0, 2}, {1, 2}});
}

TEST_CASE("links without geometry have no mesh but move what hangs on them") {
  RobotFiles files;
  const tool::Model model =
      files.read(link_text("a") + link_text("b", "") + link_text("c") +
                 joint_text("j", "revolute", "a", "b", kLimit) +
                 joint_text("k", "prismatic", "b", "c", "<axis xyz=\"0 -1 0\"/>" + kLimit));
  CHECK(model.joints.size() == 2);
  REQUIRE(model.links.size() == 2);
  CHECK(model.links[1].joint == 1);
  CHECK(model.joints[1].parent == 0);
  CHECK(model.neighbours.empty());
  CHECK(model.joints[1].type == JointType::prismatic);
  CHECK(model.joints[1].lower == -1);
  CHECK(model.joints[1].upper == 2);
}

TEST_CASE("what nothing here needs is not read, broken or not") {
  RobotFiles files;
  const std::string visual =
      "<visual><geometry><box size=\"x\"/></geometry><material "
      "name=\"gone\"/></visual><inertial><mass value=\"?\"/></inertial>";
  const tool::Model model = files.read(
      "<material/><gazebo/><transmission/><!-- --><sensor/>" + link_text("a", visual + kBall) +
      link_text("b",
                "<collision><drake:hint a=\"?\"/><verbose value=\"?\"/><geometry><sphere "
                "radius=\"1\"/></geometry></collision>") +
      joint_text("j", "revolute", "a", "b",
                 "<limit lower=\"0\" upper=\"1\" velocity=\"?\"/><dynamics damping=\"?\"/>"
                 "<safety_controller/><calibration rising=\"?\"/>"));
  CHECK(model.links.size() == 2);
}

TEST_CASE("blanks of any kind part and surround numbers, whatever the locale") {
  const auto read = [] {
    RobotFiles files;
    return files
        .read(link_text("a",
                        "<collision><origin xyz=\" 1.5\t0\n\r 2.5 \"/><geometry><box "
                        "size=\"1 1 1\"/></geometry></collision>"))
        .links[0]
        .mesh.vertices[7];
  };
  CHECK(read() == std::array<double, 3>{2, 0.5, 3});
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  CHECK(read() == std::array<double, 3>{2, 0.5, 3});
  std::locale::global(before);
}

TEST_CASE("continuous joints turn on, with limits or without") {
  RobotFiles files;
  for (const std::string limits : {"", kLimit.c_str()}) {
    const tool::Model model = files.read(chain_text({{"continuous", limits}}));
    CHECK(model.joints[0].type == JointType::continuous);
    CHECK(model.joints[0].lower == -model.joints[0].upper);
    CHECK(model.joints[0].upper == 3.14159265358979323846);
  }
}

TEST_CASE("mimics in a chain follow the joint at its end") {
  RobotFiles files;
  const tool::Model model = files.read(
      chain_text({{"revolute",
                   R"(<limit lower="-9" upper="9"/><mimic joint="j1" multiplier="2" offset="1"/>)"},
                  {"revolute", kLimit + R"(<mimic joint="j2" multiplier="-3"/>)"},
                  {"revolute", kLimit},
                  {"continuous", R"(<mimic joint="j2"/>)"}}));
  REQUIRE(model.variables == std::vector<std::size_t>{2});
  CHECK(model.joints[0].multiplier == -6);
  CHECK(model.joints[0].offset == 1);
  CHECK(model.joints[0].variable == 0);
  CHECK(model.joints[0].lower == -11);
  CHECK(model.joints[0].upper == 7);
  CHECK(model.joints[3].multiplier == 1);
  CHECK(model.joints[3].type == JointType::revolute);
  CHECK(model.joints[3].upper == 2);
}

TEST_CASE("a mimic of a continuous joint turns on, too") {
  RobotFiles files;
  const tool::Model model = files.read(chain_text(
      {{"continuous", ""}, {"revolute", kLimit + R"(<mimic joint="j0" multiplier="-2"/>)"}}));
  CHECK(model.joints[1].type == JointType::continuous);
  CHECK(model.joints[1].multiplier == -2);
  CHECK(model.joints[1].lower == -tool::kPi);
  CHECK(model.joints[1].upper == tool::kPi);
}

TEST_CASE("collision elements of a link are one mesh") {
  RobotFiles files;
  files.write("t.obj", kTriangle);
  const tool::Model model = files.read(link_text(
      "a", kBall +
               "<collision><geometry><cylinder radius=\"1\" length=\"2\"/></geometry>"
               "</collision><collision><geometry><box size=\"1 1 1\"/></geometry></collision>" +
               mesh("t.obj", "1 -2 1")));
  REQUIRE(model.links.size() == 1);
  const tool::ModelLink& link = model.links[0];
  CHECK(link.mesh.triangles.size() == 320 + 124 + 12 + 1);
  REQUIRE(link.sources.size() == 4);
  CHECK(link.sources[0] == "sphere of radius 0.1 m, up to 0.0018 m wider");
  CHECK(link.sources[1] == "cylinder of radius 1 m, up to 0.0048 m wider");
  CHECK(link.sources[2] == "box");
  CHECK(link.sources[3] == "t.obj");
  // A mirrored mesh, whose triangles are turned right side out.
  const std::uint32_t first = 162 + 64 + 8;
  CHECK(link.mesh.triangles.back() == bake::TriangleCorners{first, first + 2, first + 1});
  CHECK(link.mesh.vertices[first + 1] == std::array<double, 3>{0, -4, 0});
}

TEST_CASE("meshes are found where the field keeps them") {
  RobotFiles files;
  files.write("arm_description/meshes/t.obj", kTriangle);
  files.write("elsewhere/t.obj", kTriangle);
  files.packages["known"] = files.path("elsewhere");
  const auto reads = [&](const std::string& name) {
    files.write("arm_description/urdf/arm.urdf",
                "<robot name=\"arm\">" + link_text("a", mesh(name)) + "</robot>");
    const tool::Model model = tool::read_urdf(files.path("arm_description/urdf/arm.urdf"),
                                              files.packages, "", files.warnings);
    CHECK(model.links[0].sources[0] == name);
    return model.links[0].mesh.triangles.size() == 1;
  };
  CHECK(reads("package://arm_description/meshes/t.obj"));
  CHECK(reads("model://arm_description/meshes/t.obj"));
  CHECK(reads("package://meshes/t.obj"));  // no package, but a folder above the URDF's
  CHECK(reads("package://known/t.obj"));
  CHECK(reads("../meshes/t.obj"));
  CHECK(reads("file://" + files.path("elsewhere/t.obj")));
  CHECK(reads(files.path("elsewhere/t.obj")));
}

TEST_CASE("the unit that a 3MF carries is converted to metres") {
  RobotFiles files;
  write_3mf(files.path("t.3mf"),
            "<model unit=\"inch\"><resources><object id=\"1\"><mesh><vertices>"
            "<vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>"
            "<vertex x=\"0\" y=\"10\" z=\"0\"/></vertices><triangles><triangle "
            "v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object></resources>"
            "<build><item objectid=\"1\"/></build></model>");
  const tool::Model model = files.read(link_text("a", mesh("t.3mf", "2 2 2")));
  CHECK(model.links[0].mesh.vertices[1] == std::array<double, 3>{0.508, 0, 0});
}

TEST_CASE("an SRDF's pairs, each once, with their reasons") {
  RobotFiles files;
  files.write("arm.srdf",
              "<robot name=\"arm\"><disable_collisions link1=\"c\" link2=\"a\" reason=\"Never\"/>"
              "<disable_collisions link1=\"a\" link2=\"c\" reason=\"again\"/>"
              "<disable_collisions link1=\"a\" link2=\"bare\"/>"
              "<disable_collisions link1=\"a\" link2=\"gone\"/><group name=\"g\"/></robot>");
  const std::string robot = chain_text({{"fixed", ""}, {"fixed", ""}}) + link_text("bare", "") +
                            joint_text("l", "fixed", "a", "bare");
  const tool::Model model = files.read(robot, files.path("arm.srdf"));
  REQUIRE(model.disabled.size() == 1);
  CHECK(model.disabled[0].a == 0);
  CHECK(model.disabled[0].b == 2);
  CHECK(model.disabled[0].reason == "Never");
  CHECK(model.disabled[0].line == 1);
  files.write("bad.srdf", "<robot name=\"arm\">\n<disable_collisions link1=\"a\"/></robot>");
  CHECK_THROWS_WITH(files.read(robot, files.path("bad.srdf")),
                    Catch::Matchers::Contains("bad.srdf:2: has a <disable_collisions>"));
}

TEST_CASE("an SRDF's default is disabled for all pairs of a link but those that it enables") {
  RobotFiles files;
  files.write("arm.srdf",
              "<robot name=\"arm\">\n<disable_default_collisions link=\"a\"/>\n"
              "<enable_collisions link1=\"b\" link2=\"a\"/>\n"
              "<enable_collisions link1=\"b\" link2=\"c\"/>\n"
              "<disable_collisions link1=\"b\" link2=\"c\" reason=\"User\"/></robot>");
  const std::string robot = chain_text({{"fixed", ""}, {"fixed", ""}, {"fixed", ""}});
  const tool::Model model = files.read(robot, files.path("arm.srdf"));
  REQUIRE(model.disabled.size() == 3);
  CHECK((model.disabled[0].a == 1 && model.disabled[0].b == 2 && model.disabled[0].line == 5));
  CHECK((model.disabled[1].a == 0 && model.disabled[1].b == 2));
  CHECK(model.disabled[1].reason == "disable_default_collisions");
  CHECK((model.disabled[2].a == 0 && model.disabled[2].b == 3 && model.disabled[2].line == 2));
  files.write("bad.srdf", "<robot name=\"arm\">\n<disable_default_collisions/></robot>");
  CHECK_THROWS_WITH(files.read(robot, files.path("bad.srdf")),
                    Catch::Matchers::Contains("bad.srdf:2: has a <disable_default_collisions> that "
                                              "does not name a link; give it link"));
}

TEST_CASE("a mimic's own limits are not checked") {
  const auto [limits, type, lower, upper] = GENERATE(
      table<const char*, const char*, double, double>({{"-100\" upper=\"100", "revolute", -1, 2},
                                                       {"1\" upper=\"-1", "revolute", -1, 2},
                                                       {"-20\" upper=\"20", "revolute", -1, 2},
                                                       {"-1\" upper=\"1", "continuous", -1, 2}}));
  RobotFiles files;
  const tool::Model model =
      files.read(chain_text({{"revolute", kLimit},
                             {type, "<limit lower=\"" + std::string(limits) +
                                        "\" effort=\"1\" velocity=\"1\"/><mimic joint=\"j0\"/>"}}));
  CHECK(model.joints[1].lower == lower);
  CHECK(model.joints[1].upper == upper);
  CHECK(model.joints[1].variable == 0);
  for (const tool::PlacedWarning& warning : files.warnings.all()) {
    CHECK_THAT(warning.what, Catch::Matchers::Contains("past its own limits; they do not count"));
  }
}

TEST_CASE("soft limits narrow the limits of a joint that has its own") {
  const auto [soft, lower, upper, warning] =
      GENERATE(table<const char*, double, double, const char*>({
          {"soft_lower_limit=\"-0.5\" soft_upper_limit=\"1\"", -0.5, 1, "keeps to the soft limits"},
          {"soft_upper_limit=\"1\"", -1, 1, "-1 to 1, inside its <limit>, -1 to 2"},
          {"soft_lower_limit=\"-3\" soft_upper_limit=\"3\"", -1, 2, ""},
          {"soft_lower_limit=\"0\" soft_upper_limit=\"0\"", -1, 2, "leave no range, 0 to 0"},
          {"k_velocity=\"1\"", -1, 2, ""},
      }));
  RobotFiles files;
  const tool::Model model = files.read(
      chain_text({{"revolute", kLimit + "<safety_controller " + std::string(soft) + "/>"}}));
  CHECK(model.joints[0].lower == lower);
  CHECK(model.joints[0].upper == upper);
  REQUIRE(files.warnings.all().size() == (*warning == 0 ? 0 : 1));
  if (*warning != 0) {
    CHECK(files.warnings.all()[0].what.find(warning) != std::string::npos);
  }
}

TEST_CASE("a base that floats is fixed if all shapes float with it, no other is") {
  RobotFiles files;
  const std::string joint = joint_text("j", "floating", "world", "a");
  const std::string arm = link_texts("ab") + joint_text("k", "revolute", "a", "b", kLimit);
  const tool::Model model = files.read(link_text("world", "") + joint + arm);
  CHECK(model.joints.size() == 1);
  REQUIRE(files.warnings.all().size() == 1);
  CHECK(files.warnings.all()[0].what.find("floats and is taken for fixed") == 0);
  const std::string no = "is floating, which firmware does not move";
  for (const std::string& floating :
       {link_text("world"),
        link_texts("c") + link_text("world", "") + joint_text("l", "fixed", "world", "c"),
        link_texts("d") + link_text("c", "") + link_text("world", "") +
            joint_text("l", "fixed", "world", "c") + joint_text("m", "revolute", "c", "d", kLimit),
        link_texts("c") + link_text("world", "") + joint_text("l", "floating", "world", "c"),
        link_texts("c") + link_text("world", "") + joint_text("l", "fixed", "c", "world")}) {
    CHECK_THAT(files.refusal(floating + joint + arm), Catch::Matchers::Contains(no));
  }
}

TEST_CASE("visual shapes collide where they are all that a link has, and only if they shall") {
  RobotFiles files;
  const std::string seen =
      "<visual name=\"v\"><origin xyz=\"1 0 0\"/><geometry><box size=\"1 1 "
      "1\"/></geometry><material "
      "name=\"gone\"><color/></material></visual>";
  const std::string robot =
      link_text("a") + link_text("b", seen) +
      joint_text("j", "revolute", "a", "b", "<axis xyz=\"0 0 1\"/>" + kLimit) +
      link_text("c", kBall + seen) + joint_text("k", "revolute", "b", "c", kLimit);
  CHECK(files.read(robot).links.size() == 2);
  REQUIRE(files.warnings.all().size() == 1);
  CHECK(
      files.warnings.all()[0].what ==
      "has a <visual> but no <collision>: it collides with nothing; give it a <collision>, or let "
      "all such links collide by their visual shapes: --visual-too");
  tool::Warnings warnings;
  const tool::Model model = tool::read_urdf(files.path("arm.urdf"), {}, "", warnings, true);
  CHECK(warnings.all().empty());
  REQUIRE(model.links.size() == 3);
  CHECK(model.links[1].mesh.vertices[7] == std::array<double, 3>{1.5, 0.5, 0.5});
  CHECK(model.links[2].sources.size() == 1);
}
