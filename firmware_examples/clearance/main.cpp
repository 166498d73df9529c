// A gripper comes down on a bar and turns: how far are they apart, and may it go on?
//
// Distances are measured between surfaces: a bar wholly inside the palm is far from its walls. So
// the guard reports "free" only after a query of the solids. The last line is such a case.
//
// Prints a line per step: the distance in millimetres, the verdict, and the instructions of the
// whole check with its pose. To count them, run it by hand with FLASHBVH_ICOUNT (ports/README.md).
#include <flashbvh/clearance.hpp>
#include <flashbvh/flashbvh.hpp>
#include <flashbvh/float.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/solid.hpp>

#include "bar.fbvh.h"
#include "gripper.fbvh.h"
#include "insn.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

const Mesh bar = view_unchecked<Mesh>(bar_image);
const Mesh gripper = view_unchecked<Mesh>(gripper_image);

enum class Verdict : uint8_t { free, slow, warn, stop };
constexpr const char* kNames[] = {"free", "slow", "warn", "stop"};

/// Converts millimetres, the unit of both meshes, to 1/256 cell.
uint32_t within_mm(float length) {
  return fine_length_rounded_up(length, bar_CELLS_PER_UNIT).count;
}
const uint32_t kSlow = within_mm(20);
const uint32_t kWarn = within_mm(5);
const uint32_t kStop = within_mm(0.5f);

/// The work of a slice, in units of query.hpp.
constexpr uint32_t kWork = 100;

struct Known {
  Verdict verdict;
  uint32_t lower;  ///< the distance of the surfaces in 1/256 cell, rounded down
};

/// Remembers the nearest pair, from which the next query starts.
class Guard {
 public:
  Known at(const Pose& gripper_in_bar) {
    ClearanceQuery query(bar, gripper, gripper_in_bar, nearest_);
    while (query.run(kWork).status == Status::suspended) {
      // Not finished: a control loop continues in the next period.
    }
    const Clearance<uint16_t> known = query.result();
    nearest_ = known.witness;
    // An error is no permission to move on.
    if (known.status != Status::done || known.lower < kStop) {
      return {Verdict::stop, known.lower};
    }
    // The surfaces of a bar inside the gripper are apart, too.
    if (solids_intersect(bar, gripper, gripper_in_bar).yes) {
      return {Verdict::stop, known.lower};
    }
    return {verdict_of(known.lower), known.lower};
  }

 private:
  static Verdict verdict_of(uint32_t distance) {
    if (distance < kWarn) {
      return Verdict::warn;
    }
    return distance < kSlow ? Verdict::slow : Verdict::free;
  }

  Witness<uint16_t> nearest_;
};

/// The gripper's pose as a control loop has it: in floats, advanced by a fixed step.
struct Approach {
  float cosine = 1;  // of half the angle
  float sine = 0;
  float x = 15.0f;
  float z = 58.4f;

  Pose pose() const {
    return pose_of(UnitQuaternion{cosine, 0, 0, sine}, {x, 0, z}, bar_CELLS_PER_UNIT);
  }

  /// Moves by one millimetre sideways and four down, and turns by six degrees about the vertical.
  void step() {
    constexpr float kCosine = 0.99862953f;
    constexpr float kSine = 0.05233596f;
    const float turned = cosine * kCosine - sine * kSine;
    sine = sine * kCosine + cosine * kSine;
    cosine = turned;
    x -= 1.0f;
    z -= 4.0f;
  }
};

/// Prints millimetres with three decimals, rounded down like the distance.
void print_mm(uint32_t distance) {
  const auto micrometres = static_cast<uint32_t>(millionths_of(distance, bar.cell_bits) / 1000);
  const uint32_t rest = micrometres % 1000;
  port::print(micrometres / 1000, rest < 10 ? ".00" : rest < 100 ? ".0" : ".", rest, " mm ");
}

/// Prints a line: the verdict of the pose that `make_pose` returns.
template <class MakePose>
Verdict print_verdict(Guard& guard, const MakePose& make_pose) {
  Known known = {Verdict::stop, 0};
  const uint32_t instructions = port::instructions_of([&] { known = guard.at(make_pose()); });
  print_mm(known.lower);
  port::print(kNames[static_cast<int>(known.verdict)], ", ", instructions, " instructions\n");
  return known.verdict;
}

}  // namespace

int main() {
  constexpr unsigned kSteps = 16;
  Guard guard;
  Approach approach;
  Verdict last = Verdict::free;
  for (unsigned i = 0; i < kSteps; ++i) {
    port::print("step ", i, ": ");
    last = print_verdict(guard, [&] { return approach.pose(); });
    approach.step();
  }
  // As sensors may report at reset. The distance alone would report the gripper as free.
  port::print("bar in the palm: ");
  const Verdict inside = print_verdict(guard, [] {
    return pose_of(UnitQuaternion{1, 0, 0, 0}, {0, 0, -36.0f}, bar_CELLS_PER_UNIT);
  });
  return last == Verdict::stop && inside == Verdict::stop ? 0 : 1;
}
