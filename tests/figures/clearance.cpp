// Distances of the KR5's links in the poses of kr5.cpp: cold, and seeded by the witness of the pose
// before, 10 cells away. Ends with 1 if both differ.
#include "flashbvh/clearance.hpp"

#include "asked.hpp"
#include "insn.hpp"
#include "report.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells

/// The poses of one class under one kind of motion.
struct OfClass {
  Spread instructions;
  Spread visits;
  Spread leaf_pairs;

  void print(const char* how, const char* motion, const char* name) const {
    print_figures({{"clearance", how, motion, name}}, instructions);
    print_counts({{"clearance_visits", how, motion, name}}, visits);
    print_counts({{"clearance_leaf_pairs", how, motion, name}}, leaf_pairs);
  }
};

Clearance<uint16_t> ask(const AskedPair& pair, const Pose& pose, const Witness<uint16_t>& seed,
                        OfClass& of_class) {
  ClearanceQuery query(*pair.a, *pair.b, pose, seed);
  (void)query.run(UINT32_MAX);
  const Clearance<uint16_t> found = query.result();
  of_class.visits.add(query.counts().visits);
  of_class.leaf_pairs.add(query.counts().leaf_pairs);
  of_class.instructions.add(port::instructions_of([&] {
    ClearanceQuery measured(*pair.a, *pair.b, pose, seed);
    (void)measured.run(UINT32_MAX);
  }));
  return found;
}

bool ask_both(const AskedPair& pair, const Asked& asked, OfClass& cold, OfClass& seeded) {
  const Pose pose = pose_of(asked);
  Asked before = asked;
  before.cells[0] += kStep;
  const Clearance<uint16_t> near = distance(*pair.a, *pair.b, pose_of(before));
  const Clearance<uint16_t> first = ask(pair, pose, {}, cold);
  const Clearance<uint16_t> second = ask(pair, pose, near.witness, seeded);
  return first.status == Status::done && first.lower == second.lower && first.upper == second.upper;
}

using PosesOfPair = Asked (AskedPair::*)[kProximities][kPosesOfPair];

bool ask_all(const char* motion, PosesOfPair poses) {
  bool good = true;
  for (uint32_t i = 0; i < kProximities; ++i) {
    OfClass cold;
    OfClass seeded;
    for (uint32_t p = 0; p < kAskedPairCount; ++p) {
      for (const Asked& asked : (kAskedPairs[p].*poses)[i]) {
        good = ask_both(kAskedPairs[p], asked, cold, seeded) && good;
      }
    }
    cold.print("cold", motion, kProximityNames[i]);
    seeded.print("seeded", motion, kProximityNames[i]);
  }
  return good;
}

}  // namespace
}  // namespace figures

int main() {
  figures::print_core();
  const bool translated = figures::ask_all("translated", &figures::AskedPair::translated);
  const bool rotated = figures::ask_all("rotated", &figures::AskedPair::rotated);
  return translated && rotated ? 0 : 1;
}
