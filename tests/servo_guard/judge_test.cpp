// The judge of the servo guard: distances of the URDF's own meshes, in doubles, where servos were.
//
// FLASHBVH_JUDGE="URDF IMAGE POSITIONS BRAKE [PACKAGE=FOLDER]...", with the test "[judge]": a line
// of POSITIONS is "start" or the values of all variables, in a joint's coordinates. BRAKE, in
// metres: how much nearer than they may links get. A pair that starts inside its stop distance may
// come as near as a tenth of that below the largest distance so far.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "robot/baked/robot_file.hpp"
#include "robot/pipeline/request.hpp"
#include "robot/read/urdf.hpp"
#include "support/arms/drawn_robot.hpp"

using namespace flashbvh::tool;

namespace {

struct Judge {
  /// Whether no pair is too near. Pairs may start inside.
  bool allows(const Values& at, bool is_start) {
    const std::vector<Transform> frames = drawn.frames(at, 1);
    bool allows = true;
    is_inside = false;
    for (std::size_t i = 0; i < floors.size(); ++i) {
      const double stop = drawn.robot.pairs[i].stop;
      double now = stop;  // or less, to 1/64, rounded down
      if (drawn.is_nearer(i, frames, stop)) {
        now = 0;
        for (double more = stop / 2; more >= stop / 64; more /= 2) {
          now += drawn.is_nearer(i, frames, now + more) ? 0 : more;
        }
      }
      floors[i] = is_start ? now : floors[i];
      const double give = floors[i] < stop ? std::min(drawn.give(i), floors[i] / 2) : 0;
      const bool is_near = now < floors[i] - give - brake / drawn.cell * kFineOne;
      if (is_near && allows) {
        std::printf("%s: %.2f of a stop distance\n", drawn.name_of(i).c_str(), now / stop);
      }
      allows = allows && !is_near;
      is_inside = is_inside || now < stop;
      floors[i] = std::max(floors[i], now);
      nearest = std::min(nearest, now / stop);
    }
    return allows;
  }

  Drawn& drawn;
  double brake;  ///< in metres
  std::vector<double> floors = std::vector<double>(drawn.robot.pair_count);
  double nearest = 1;  ///< part of a stop distance
  bool is_inside = false;
};

}  // namespace

TEST_CASE("servo judge: an arm that is sent into itself is seen") {
  Random random = test_random();
  int seen = 0;
  for (int i = 0; i < 4; ++i) {
    const FixedArm arm(any_guarded_arm(random, 4, 5e-5));
    Drawn drawn(arm.robot(), arm.model, random);
    Judge judge{drawn, 0};
    CHECK(judge.allows(drawn.free_place(), true));
    CHECK(!judge.is_inside);
    seen += judge.allows(drawn.any(true, 0, 0), false) ? 0 : 1;
  }
  CHECK(seen > 0);
}

TEST_CASE("servo judge: the positions of FLASHBVH_JUDGE", "[.][judge]") {
  std::istringstream words(setting("FLASHBVH_JUDGE"));
  const std::vector<std::string> given(std::istream_iterator<std::string>(words), {});
  REQUIRE(given.size() >= 4);
  Warnings warnings;
  const RobotFile image(given[1]);
  const Packages packages = packages_of({given.begin() + 4, given.end()});
  Random random = test_random();
  Drawn drawn(image.robot(), read_urdf(given[0], packages, "", warnings), random);
  Judge judge{drawn, std::stod(given[3])};
  std::ifstream file(given[2]);
  long positions = 0;
  long wrong = 0;
  long inside = 0;
  long out = 0;
  bool is_start = true;
  for (std::string line; std::getline(file, line); is_start = line == "start") {
    std::istringstream numbers(line);
    const Values at(std::istream_iterator<std::int32_t>(numbers), {});
    if (at.empty()) {
      continue;
    }
    const bool was_inside = judge.is_inside;
    ++positions;
    wrong += judge.allows(at, is_start) ? 0 : 1;
    inside += is_start && judge.is_inside ? 1 : 0;
    out += !is_start && was_inside && !judge.is_inside ? 1 : 0;
  }
  std::printf(
      "%ld positions, too near %ld, starts inside %ld, came out %ld; nearest %.2f of a stop "
      "distance\n",
      positions, wrong, inside, out, judge.nearest);
  CHECK(wrong == 0);
  CHECK(positions > 0);
}
