// The links of a KUKA KR5, pair by pair, in the poses that write_poses found for four classes of
// proximity. Ends with 1 if a query counts anything else than on the host.
#include "asked.hpp"
#include "insn.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr const char* kSet = "kr5";

bool agrees(const Asked& asked, const Walked& walked, const Queried& queried) {
  const Counts& counts = queried.counts;
  return queried.status == Status::done && counts.visits == asked.visits &&
         counts.leaf_pairs == asked.leaf_pairs && counts.triangle_pairs == asked.triangle_pairs &&
         queried.work == asked.work && walked.visits == asked.visits &&
         walked.leaf_pairs == asked.leaf_pairs;
}

/// The poses of one class under one kind of motion.
struct OfClass {
  Spread visits;
  Spread leaf_pairs;
  Spread triangle_pairs;
  Spread work;
  Spread queries;
  Spread until_first;

  void add(const Queried& queried) {
    visits.add(queried.counts.visits);
    leaf_pairs.add(queried.counts.leaf_pairs);
    triangle_pairs.add(queried.counts.triangle_pairs);
    work.add(queried.work);
    counted.add(queried.counts);
    counted.add(queried.work);
    queries.add(queried.instructions);
    until_first.add(queried.until_first);
  }

  void print(const char* motion, Proximity proximity) const {
    const char* const name = kProximityNames[static_cast<uint32_t>(proximity)];
    print_counts({{kSet, motion, name, "visits"}}, visits);
    print_counts({{kSet, motion, name, "leaf_pairs"}}, leaf_pairs);
    print_counts({{kSet, motion, name, "triangle_pairs"}}, triangle_pairs);
    print_counts({{kSet, motion, name, "work"}}, work);
    print_figures({{kSet, motion, name, "query"}}, queries);
    if (proximity == Proximity::intersecting) {
      print_figures({{kSet, motion, name, "first"}}, until_first);
    }
  }
};

/// False, with a line that says so, if anything differs from what the host counted.
bool ask(const AskedPair& pair, const Asked& asked, OfClass& of_class, Motion& motion) {
  const Pose pose = pose_of(asked);
  const Walked walked = measure_walk(*pair.a, *pair.b, pose);
  const Queried queried = measure_query(*pair.a, *pair.b, pose);
  of_class.add(queried);
  motion.add(walked, queried);
  if (agrees(asked, walked, queried)) {
    return true;
  }
  port::print("differs: ", pair.a_name, " ", pair.b_name, ": ", queried.counts.visits,
              " visits, on the host ", asked.visits, "\n");
  return false;
}

using PosesOfPair = Asked (AskedPair::*)[kProximities][kPosesOfPair];

/// Translated only, or rotated, too.
bool ask_all(const char* name, PosesOfPair poses, Spread& triangle_tests) {
  bool good = true;
  Motion motion;
  for (uint32_t i = 0; i < kProximities; ++i) {
    const auto proximity = static_cast<Proximity>(i);
    OfClass of_class;
    for (uint32_t p = 0; p < kAskedPairCount; ++p) {
      const AskedPair& pair = kAskedPairs[p];
      for (const Asked& asked : (pair.*poses)[i]) {
        good = ask(pair, asked, of_class, motion) && good;
        add_triangle_tests(*pair.a, *pair.b, pose_of(asked), triangle_tests);
      }
    }
    of_class.print(name, proximity);
  }
  motion.print(kSet, name);
  return good;
}

/// What it takes to have a pose: made of integers, and made of two others.
void measure_poses() {
  Spread made;
  Spread relative;
  for (uint32_t p = 0; p < kAskedPairCount; ++p) {
    for (const Asked& asked : kAskedPairs[p].rotated[0]) {
      const int16_t(&q)[4] = asked.quaternion;
      const test::Rotation rotation = test::rotation_of({q[0], q[1], q[2], q[3]});
      const Pose world = pose_of(asked);
      const Pose other = pose_of(kAskedPairs[p].rotated[1][0]);
      Pose pose = Pose::translated(0, 0, 0);
      made.add(port::instructions_of([&] { pose = Pose::rigid(rotation.entry, asked.cells); }));
      relative.add(port::instructions_of([&] { pose = Pose::relative(other, world); }));
    }
  }
  print_figures({{"pose", "rigid"}}, made);
  print_figures({{"pose", "relative"}}, relative);
}

bool run() {
  print_core();
  Spread triangle_tests;
  const bool translated = ask_all("translated", &AskedPair::translated, triangle_tests);
  const bool rotated = ask_all("rotated", &AskedPair::rotated, triangle_tests);
  print_figures({{kSet, "triangle_test"}}, triangle_tests);
  print_count({{kSet, "triangle_tests"}}, triangle_tests.count());
  measure_poses();
  print_count({{kSet, "digest"}}, counted.value());
  return translated && rotated;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::run() ? 0 : 1;
}
