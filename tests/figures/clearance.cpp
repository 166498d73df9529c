// Distances of the KR5's links in the poses of kr5.cpp: cold, and seeded by the witness of the pose
// before, 10 cells away. Ends with 1 if both differ.
#include "flashbvh/clearance.hpp"

#include "asked.hpp"
#include "insn.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

constexpr int32_t kStep = 10;  // cells

/// The poses of one class under one kind of motion.
struct OfClass {
  Spread instructions;
  Spread visits;

  void print(const char* how, const char* motion, const char* name) const {
    print_figures({{"distance", motion, name, how}}, instructions);
    print_counts({{"distance", motion, name, how, "visits"}}, visits);
  }
};

/// What walks took.
struct Walks {
  uint64_t visits = 0;
  uint64_t instructions = 0;
};

/// What a visit takes, and two triangles as queries come to them, under one kind of motion.
struct Parts {
  Walks all;
  Walks inner;  ///< outside the leaf phase, as measure.hpp has it of intersection
  Spread within;
  Spread nearest;

  void print(const char* motion) const {
    print_quotient({{"distance", "visit", motion, "mean"}}, inner.instructions, inner.visits);
    print_quotient({{"distance", "leaf_visit", motion, "mean"}},
                   all.instructions - inner.instructions, all.visits - inner.visits);
    print_figures({{"distance", "within", motion}}, within);
    print_figures({{"distance", "nearest", motion}}, nearest);
  }
};

/// A question whose tests are measured.
template <class Question>
struct Timed : Question {
  Spread* tests = nullptr;

  bool test(const Triangle& a, const Triangle& b, uint32_t i, uint32_t j) {
    bool yes = false;
    tests->add(port::instructions_of([&] { yes = Question::test(a, b, i, j); }));
    return yes;
  }
};

template <class Question>
void run_all(const AskedPair& pair, const Pose& pose, const Question& question) {
  Query<Ranked<PostMesh>, Question> query(*pair.a, *pair.b, pose, {}, question);
  (void)query.run(UINT32_MAX, [](const TrianglePair<uint16_t>&) { return true; });
}

void measure_tests(const AskedPair& pair, const Pose& pose, const Clearance<uint16_t>& known,
                   Parts& parts) {
  Timed<Within> within;
  within.tests = &parts.within;
  static_cast<Within&>(within) = flashbvh::within(known.lower);
  run_all(pair, pose, within);

  Transform transform(pose, *pair.a, *pair.b, /*may_stop=*/false);
  Triangle a;
  Triangle b;
  translate_triangle(*pair.a, known.witness.a, kNoOffset, a);
  transform_triangle(*pair.b, known.witness.b, transform, b);
  NearestSoFar so_far;
  Timed<Nearest<uint16_t>> nearest;
  Spread seed;
  nearest.tests = &seed;
  nearest.so_far = &so_far;
  (void)nearest.test(a, b, known.witness.a, known.witness.b);
  nearest.tests = &parts.nearest;
  run_all(pair, pose, nearest);
}

template <class Shapes, class Bound, class Handle>
void add_walk(const AskedPair& pair, const Transform& transform, Bound& bound, const Handle& handle,
              Walks& walks) {
  Shapes shapes(*pair.a, *pair.b, transform);
  shapes.set_bound(bound);
  uint32_t leaf_pairs = 0;
  auto leaf_pair = [&leaf_pairs](uint32_t, uint32_t, const Progress&) { return ++leaf_pairs != 0; };
  PairCursor<uint16_t> cursor;
  WalkRun<PairCursor<uint16_t>, decltype(leaf_pair)> run(cursor, leaf_pair, UINT32_MAX);
  walks.instructions += port::instructions_of(
      [&] { (void)walk<Ranked<PostMesh>>(handle, shapes, run, State::fresh); });
  walks.visits += UINT32_MAX - run.progress.visits_down();
}

template <class Shapes>
void add_walk(const AskedPair& pair, const Transform& transform, uint32_t distance, Walks& walks) {
  const Within question = within(distance);
  if (question.is_kept(transform)) {
    KeptGap bound = question.kept(transform);
    add_walk<Shapes>(pair, transform, bound, ByReference<KeptGap>{&bound}, walks);
  } else {
    const TranslatedGap bound = question.translated(transform.translated());
    add_walk<Shapes>(pair, transform, bound, bound, walks);
  }
}

/// Walks alone, of pairs within the distance.
void measure_walks(const AskedPair& pair, const Pose& pose, uint32_t distance, Parts& parts) {
  Transform transform(pose, *pair.a, *pair.b, /*may_stop=*/false);
  transform.prepare(*pair.b);
  add_walk<NearShapes<PostMesh>>(pair, transform, distance, parts.all);
  add_walk<NothingBelow>(pair, transform, distance, parts.inner);
}

Clearance<uint16_t> ask(const AskedPair& pair, const Pose& pose, const Witness<uint16_t>& seed,
                        OfClass& of_class) {
  ClearanceQuery query(*pair.a, *pair.b, pose, seed);
  (void)query.run(UINT32_MAX);
  of_class.visits.add(query.counts().visits);
  counted.add(query.counts());
  Clearance<uint16_t> found{};
  of_class.instructions.add(
      port::instructions_of([&] { found = distance(*pair.a, *pair.b, pose, seed); }));
  counted.add(found.lower);
  counted.add(found.upper);
  return found;
}

bool ask_both(const AskedPair& pair, const Asked& asked, OfClass& cold, OfClass& seeded,
              Parts& parts) {
  const Pose pose = pose_of(asked);
  Asked before = asked;
  before.cells[0] += kStep;
  const Clearance<uint16_t> near = distance(*pair.a, *pair.b, pose_of(before));
  const Clearance<uint16_t> first = ask(pair, pose, {}, cold);
  const Clearance<uint16_t> second = ask(pair, pose, near.witness, seeded);
  if (second.lower != 0 && second.lower <= kMaxDistance) {
    measure_tests(pair, pose, second, parts);
    measure_walks(pair, pose, second.lower, parts);
  }
  return first.status == Status::done && first.lower == second.lower && first.upper == second.upper;
}

using PosesOfPair = Asked (AskedPair::*)[kProximities][kPosesOfPair];

bool ask_all(const char* motion, PosesOfPair poses) {
  bool good = true;
  Parts parts;
  for (uint32_t i = 0; i < kProximities; ++i) {
    OfClass cold;
    OfClass seeded;
    for (uint32_t p = 0; p < kAskedPairCount; ++p) {
      for (const Asked& asked : (kAskedPairs[p].*poses)[i]) {
        good = ask_both(kAskedPairs[p], asked, cold, seeded, parts) && good;
      }
    }
    cold.print("cold", motion, kProximityNames[i]);
    seeded.print("seeded", motion, kProximityNames[i]);
  }
  parts.print(motion);
  return good;
}

}  // namespace
}  // namespace figures

int main() {
  figures::print_core();
  const bool translated = figures::ask_all("translated", &figures::AskedPair::translated);
  const bool rotated = figures::ask_all("rotated", &figures::AskedPair::rotated);
  figures::print_count({{"distance", "digest"}}, figures::counted.value());
  return translated && rotated ? 0 : 1;
}
