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

class Judge {
 public:
  Judge(Drawn& drawn, double brake)
      : drawn_(drawn), brake_(brake / drawn.cell * kFineOne), nearest(count(), HUGE_VAL) {}

  void start(const Values& at) {
    floors_.clear();
    for (std::size_t i = 0; i < count(); ++i) {
      floors_.push_back(distance(i, drawn_.frames(at, 1), stop(i)));
    }
  }
  /// Whether no pair is too near.
  bool allows(const Values& at) {
    const std::vector<Transform> frames = drawn_.frames(at, 1);
    bool allows = true;
    for (std::size_t i = 0; i < count(); ++i) {
      if (!drawn_.is_nearer(i, frames, stop(i) + 1)) {
        floors_[i] = stop(i);
        continue;
      }
      const double now = distance(i, frames, stop(i));
      const double give = floors_[i] < stop(i) ? std::min(drawn_.give(i), floors_[i] / 2) : 0;
      allows = allows && now >= floors_[i] - give - brake_;
      floors_[i] = std::max(floors_[i], now);
      nearest[i] = std::min(nearest[i], now);
    }
    return allows;
  }
  bool is_inside() const {
    bool is = false;
    for (std::size_t i = 0; i < count(); ++i) {
      is = is || floors_[i] < stop(i);
    }
    return is;
  }

 private:
  std::size_t count() const { return drawn_.robot.pair_count; }
  double stop(std::size_t i) const { return drawn_.robot.pairs[i].stop; }
  /// To 1/64 of the stop distance, rounded down.
  double distance(std::size_t i, const std::vector<Transform>& frames, double most) {
    double least = 0;
    while (most - least > stop(i) / 64) {
      const double middle = (least + most) / 2;
      (drawn_.is_nearer(i, frames, middle) ? most : least) = middle;
    }
    return drawn_.is_nearer(i, frames, most) ? least : most;
  }

  Drawn& drawn_;
  double brake_;
  std::vector<double> floors_;

 public:
  std::vector<double> nearest;  ///< of each pair inside its stop distance, in 1/256 cell
};

}  // namespace

TEST_CASE("servo judge: an arm that is sent into itself is seen") {
  Random random = test_random();
  int seen = 0;
  for (int i = 0; i < 4; ++i) {
    const FixedArm arm(any_guarded_arm(random, 4, 5e-5));
    Drawn drawn(arm.robot(), arm.model, random);
    Judge judge(drawn, 0);
    const Values from = drawn.free_place();
    judge.start(from);
    CHECK(judge.allows(from));
    CHECK(!judge.is_inside());
    seen += judge.allows(drawn.any(true, 0, 0)) ? 0 : 1;
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
  Judge judge(drawn, std::stod(given[3]));
  std::ifstream file(given[2]);
  long positions = 0;
  long wrong = 0;
  long inside = 0;
  long out = 0;
  bool is_start = true;
  bool was_inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "start") {
      is_start = true;
      continue;
    }
    std::istringstream numbers(line);
    const Values at(std::istream_iterator<std::int32_t>(numbers), {});
    if (std::exchange(is_start, false)) {
      judge.start(at);
      inside += judge.is_inside() ? 1 : 0;
      was_inside = judge.is_inside();
    }
    ++positions;
    wrong += judge.allows(at) ? 0 : 1;
    out += was_inside && !judge.is_inside() ? 1 : 0;
    was_inside = judge.is_inside();
  }
  std::printf("%ld positions, too near %ld, starts inside %ld, came out %ld\n", positions, wrong,
              inside, out);
  for (std::size_t i = 0; i < judge.nearest.size(); ++i) {
    if (judge.nearest[i] < HUGE_VAL) {
      std::printf("  %s: %.2f mm, stops at %.2f\n", drawn.name_of(i).c_str(),
                  judge.nearest[i] * drawn.cell / kFineOne * 1000,
                  drawn.robot.pairs[i].stop * drawn.cell / kFineOne * 1000);
    }
  }
  CHECK(wrong == 0);
  CHECK(positions > 0);
}
