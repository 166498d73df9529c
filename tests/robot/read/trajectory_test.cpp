// Joint values from CSV files.
#include "robot/replay/replay.hpp"
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"

namespace {

/// Variables "a" and "b"; "c" is -2 b + 0.5.
tool::Model arm(RobotFiles& files) {
  return files.read(link_text("base") + link_text("one") + link_text("two") + link_text("three") +
                    joint_text("a", "revolute", "base", "one", kLimit) +
                    joint_text("fixed", "fixed", "one", "two") +
                    joint_text("b", "revolute", "two", "three", kLimit) + link_text("four") +
                    joint_text("c", "revolute", "three", "four",
                               kLimit + "<mimic joint=\"b\" multiplier=\"-2\" offset=\"0.5\"/>"));
}

struct Given {
  RobotFiles files;
  tool::Model model = arm(files);
  tool::Warnings warnings;  ///< of all that was read

  tool::Trajectory read(const std::string& text) {
    files.write("way.csv", text);
    return tool::read_trajectory(files.path("way.csv"), model, warnings);
  }
  /// The refusal, from the file's name on.
  std::string refusal(const std::string& text) {
    const std::string what = refusal_of([&] { return read(text); });
    return what.substr(what.find("way.csv"));
  }
};

}  // namespace

TEST_CASE("columns in any order, comments, blanks and line ends") {
  Given given;
  const tool::Trajectory way =
      given.read("\xEF\xBB\xBF# to the left\r\n b ,a# names\r\n\r\n +1.5e-1,\t-2\r# nothing\n3,4");
  REQUIRE(way.size() == 2);
  CHECK(way.lines[0] == 4);
  CHECK(way.values(0)[0] == -2.0f);
  CHECK(way.values(0)[1] == 0.15f);
  CHECK(way.lines[1] == 6);
  CHECK(way.values(1)[0] == 4.0f);
  CHECK(way.values(1)[1] == 3.0f);
}

TEST_CASE("columns of times, of joints that mimic and without a name") {
  Given given;
  const char* const text =
      GENERATE("b,a,c\n 0.5, 2,-0.5\n", "b,a,c\n0.5 \t,2,-0.501\n", "a,b\n2,0.5\n",
               "time,b,stamp_ns,a\n0,0.5,1700000000000000000,2\n0,0.5,1700000000000000000,2\n",
               "T [ms],a,b\n5,2,0.5\n", "header.stamp,a,b\n2026-11-24 10:00,2,0.5\n",
               "time_from_start,c,b,a\n-1e300,-0.5,0.5,2\n",
               "%time,,a,b\n0,x,2,0.5\n");  // rostopic echo -p, pandas
  const tool::Trajectory way = given.read(text);
  CHECK(way.values(0)[0] == 2.0f);
  CHECK(way.values(0)[1] == 0.5f);
}

namespace {

struct Timed {
  const char* text;
  std::vector<double> times;
  std::vector<std::string> warnings;  ///< "place: message", from the file's name on
};

std::vector<Timed> timed_files() {
  const std::string period = "each line is one period after the line before";
  return {
      {"a,b\n0,0\n", {}, {}},
      {"time,a,b\n0.5,0,0\n0.6,0,0\n0.7,0,0\n", {0.5, 0.6, 0.7}, {}},
      {"a,secs,b\n0,7,0\n", {7}, {}},
      // Nanoseconds; a double rounds them to some hundred.
      {"t,a,b\n1700000000000000000,0,0\n1700000000001000000,0,0\n1700000000002000300,0,0\n",
       {1700000000000000000., 1700000000001000000., 1700000000002000300.},
       {}},
      {"time,a,b\n0,0,0\n0.01,0,0\n0.0209,0,0\n", {0, 0.01, 0.0209}, {}},
      {"time,a,b\n0,0,0\n0.01,0,0\n#\n0.03,0,0\n0.07,0,0\n",
       {0, 0.01, 0.03, 0.07},
       {"way.csv:5: 'time' steps by 0.02, the first time by 0.01; " + period}},
      {"time,a,b,stamp\n0,0,0,5\n", {0}, {"way.csv: the column 'stamp' is not used: " + period}},
      {"time,a,b\n0,0,0\n10:00,0,0\n", {}, {"way.csv: the column 'time' is not used: " + period}},
  };
}

}  // namespace

TEST_CASE("the first column of times names the lines") {
  for (const Timed& timed : timed_files()) {
    INFO(timed.text);
    Given given;
    const tool::Trajectory way = given.read(timed.text);
    REQUIRE(way.times.size() == timed.times.size());
    for (std::size_t i = 0; i < timed.times.size(); ++i) {
      CHECK(way.times[i] == timed.times[i]);
    }
    REQUIRE(given.warnings.all().size() == timed.warnings.size());
    for (std::size_t i = 0; i < timed.warnings.size(); ++i) {
      const auto& [place, what] = given.warnings.all()[i];
      CHECK(place.substr(place.find("way.csv")) + ": " + what == timed.warnings[i]);
    }
  }
}

TEST_CASE("a joint named like a time is a joint") {
  RobotFiles files;
  const tool::Model model = files.read(link_text("base") + link_text("one") +
                                       joint_text("t", "revolute", "base", "one", kLimit));
  files.write("way.csv", "time,t\n0,2\n0.1,1\n");
  tool::Warnings warnings;
  CHECK(tool::read_trajectory(files.path("way.csv"), model, warnings).values(1)[0] == 1.0f);
}

TEST_CASE("limits are the guard's") {
  CHECK(Given().read("a,b\n1e30,-0\n").values(0)[0] == 1e30f);
}

TEST_CASE("trajectories that are refused") {
  Given given;
  const auto [text, said] = GENERATE(table<const char*, const char*>(
      {{"a,b,a\n", "way.csv:1: has two columns 'a'; leave one out"},
       {"\na,b,fixed\n",
        "way.csv:2: the column 'fixed' is no joint of the robot that moves; its joints are a,b"},
       {"a,b\n1,0,0.1\n", "way.csv:2: has 3 values, the first line names 2 columns; give each one"},
       {"\xFF\xFE"
        "a",
        "way.csv: is text in UTF-16; save it as UTF-8"},
       {"time,a,b\n0.1,0,0\n0.1,0,0\nx,0,0\n0.05,0,0\n",
        "way.csv:5: 'time' goes back from 0.1 to 0.05; each line is one period after the line "
        "before: sort them"},
       {"c,a,b\n0.499,0,0\n-1.4,0,1\n",
        "way.csv:3: 'c' is -1.4, but it follows 'b', which puts it at -1.5; leave the column out, "
        "or correct the value"},
       {"a,b\n1,-3.5e38\n",
        "way.csv:2: '-3.5e38' in the column 'b' is no finite number; give radians, or metres"},
       {"a,b\n", "way.csv: has no line of values; give one a period"},
       {"#\n", "way.csv: has no line that names the joints: a,b"}}));
  CHECK(given.refusal(text) == said);
}
