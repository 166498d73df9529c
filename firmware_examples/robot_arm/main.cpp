// Does a robot arm hit itself? A KUKA KR5 on a microcontroller: computes the links' poses from the
// joint angles in float, and exact answers from these poses.
//
// Prints lines that tools/demo.sh compares with the host's results. For every configuration C:
//     arm C six angles in degrees
//     answer C yes|no instructions      of the whole check: kinematics, poses, queries
//     kinematics C instructions         of the kinematics in it
// for every pair of links A, B:
//     pose C A B nine entries of the rotation in 2^-30, three cells, three 1/65,536 of cells
// and for every traversal, or only for the traversal that an argument names:
//     result C A B traversal visits overlaps leaf_pairs triangle_pairs stack instructions
// stack: bytes that run() needs at most, without the query object and a stack traversal's array,
// which the caller provides. instructions: of the whole query, in slices of 100 work.
#include <string.h>

#include <flashbvh/flashbvh.hpp>

#include "arm.hpp"
#include "configurations.hpp"
#include "insn.hpp"
#include "links.hpp"
#include "reference/levels.hpp"
#include "reference/traversals.hpp"
#include "stack.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

bool failed = false;
/// The only traversal to measure; nullptr: all.
const char* wanted = nullptr;

/// The build compiled the post-indexed images; the pre-indexed images are bytes, which are checked.
struct Trees {
  MeshWithLevels post[kLinkCount];
  PreMeshWithLevels pre[kLinkCount];

  bool open() {
    for (int i = 0; i < kLinkCount; ++i) {
      const Link& from = robot::kLinks[i];
      post[i] = view_with_levels<MeshWithLevels>(from.post);
      const Status status = open_image(from.pre, from.pre_bytes(), pre[i]);
      if (status != Status::done) {
        port::print("error: the image of ", from.name, " does not open: status ",
                    static_cast<unsigned>(status), "\n");
        return false;
      }
    }
    return true;
  }
};
Trees trees;

ArmPose arm_pose(const Configuration& configuration) {
  float angles[kJointCount];
  for (int i = 0; i < kJointCount; ++i) {
    angles[i] = radians(configuration.degrees[i]);
  }
  return ::arm_pose(angles);
}

/// True if links that are not neighbours touch: neighbours share a bearing. An undecided pair
/// counts as touching.
bool hits_itself(const ArmPose& arm) {
  for (int a = 0; a < kLinkCount; ++a) {
    for (int b = a + 2; b < kLinkCount; ++b) {
      const Pose pose = Pose::relative(arm.link[a], arm.link[b]);
      if (intersects<uint16_t>(trees.post[a], trees.post[b], pose).yes) {
        return true;
      }
    }
  }
  return false;
}

/// Two links in a configuration.
struct Case {
  const char* configuration;
  int a;
  int b;
  const Pose& pose;

  const char* name_a() const { return robot::kLinks[a].name; }
  const char* name_b() const { return robot::kLinks[b].name; }
};

void print_pose(const Case& what) {
  port::print("pose ", what.configuration, " ", what.name_a(), " ", what.name_b());
  for (int i = 0; i < 9; ++i) {
    port::print(" ", what.pose.rotation(i / 3, i % 3));
  }
  for (int i = 0; i < 3; ++i) {
    port::print(" ", what.pose.translation(i));
  }
  for (int i = 0; i < 3; ++i) {
    port::print(" ", what.pose.fraction(i));
  }
  port::print("\n");
}

/// Runs 100 work at a time, like a control loop. `run_slice(found)` runs one slice into the array.
template <class Query, class Slice>
void run_to_end(const Query& query, Slice run_slice) {
  typename Query::Pair found[4];
  while (query.status() == Status::suspended) {
    run_slice(found);
  }
  failed = failed || query.status() != Status::done;
}

/// `start()` returns the initial cursor of a traversal: each query uses up its array.
template <class Traversal, class Start>
void measure(const Case& what, const char* algorithm, const typename Traversal::Tree& a,
             const typename Traversal::Tree& b, Start start) {
  if (wanted != nullptr && strcmp(wanted, algorithm) != 0) {
    return;
  }
  using Pair = typename Query<Traversal>::Pair;
  Query<Traversal> query(a, b, what.pose, start());
  uint32_t stack = 0;
  run_to_end(query, [&](Pair(&found)[4]) {
    const uint32_t used = port::stack_of([&] { (void)query.run(100, found); });
    stack = used > stack ? used : stack;
  });
  const uint32_t instructions = port::instructions_of([&] {
    Query<Traversal> again(a, b, what.pose, start());
    run_to_end(again, [&](Pair(&found)[4]) { (void)again.run(100, found); });
    failed = failed || again.stats().visits != query.stats().visits;
  });
  const QueryStats& counts = query.stats();
  port::print("result ", what.configuration, " ", what.name_a(), " ", what.name_b(), " ",
              algorithm);
  port::print(" ", counts.visits, " ", counts.overlaps, " ", counts.leaf_pairs, " ",
              counts.triangle_pairs, " ", stack, " ", instructions, "\n");
}

template <class Traversal>
void measure(const Case& what, const char* algorithm) {
  measure<Traversal>(what, algorithm, trees.post[what.a], trees.post[what.b],
                     [] { return typename Traversal::Cursor(); });
}

template <class Traversal>
void measure_with_stack(const Case& what, const char* algorithm) {
  PairStack<uint16_t>::Entry entries[stack_entries(robot::kStackNeed, robot::kStackNeed)];
  measure<Traversal>(what, algorithm, trees.post[what.a], trees.post[what.b], [&] {
    return PairStack<uint16_t>(entries, sizeof entries / sizeof entries[0]);
  });
}

/// A pose of these numbers alone, as the host reads them: the error bounds of a composed pose would
/// widen its margins, and might add a visit.
Pose made_of_numbers(const Pose& pose) {
  int32_t rotation[3][3];
  for (int i = 0; i < 9; ++i) {
    rotation[i / 3][i % 3] = pose.rotation(i / 3, i % 3);
  }
  const int32_t cells[3] = {pose.translation(0), pose.translation(1), pose.translation(2)};
  int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    fraction[i] = static_cast<int16_t>(pose.fraction(i));
  }
  return Pose::rigid(rotation, cells, fraction);
}

void measure_pair(const Configuration& configuration, const ArmPose& arm, int a, int b) {
  const Pose pose = made_of_numbers(Pose::relative(arm.link[a], arm.link[b]));
  const Case what = {configuration.name, a, b, pose};
  print_pose(what);
  measure<Ranked<Mesh>>(what, "ranked");
  measure<StacklessPost>(what, "stackless-post");
  measure<Stackless>(what, "stackless", trees.pre[a], trees.pre[b],
                     [] { return Stackless::Cursor(); });
  measure<Leaf<Mesh>>(what, "leaf");
  measure_with_stack<RankedStack<Mesh>>(what, "ranked-stack");
  measure_with_stack<VolumeStack<Mesh>>(what, "volume-stack");
  measure_with_stack<AlternatingStack<MeshWithLevels>>(what, "alternating-stack");
}

/// Runs the query as a controller does.
void check(const Configuration& configuration) {
  bool yes = true;
  const uint32_t whole = port::instructions_of([&] { yes = hits_itself(arm_pose(configuration)); });
  port::print("arm ", configuration.name);
  for (const int degrees : configuration.degrees) {
    port::print(" ", degrees);
  }
  port::print("\nanswer ", configuration.name, yes ? " yes " : " no ", whole, "\n");
}

void measure_pairs(const Configuration& configuration, int nearest) {
  ArmPose arm = arm_pose(configuration);
  const uint32_t kinematics = port::instructions_of([&] { arm = arm_pose(configuration); });
  port::print("kinematics ", configuration.name, " ", kinematics, "\n");
  for (int a = 0; a < kLinkCount; ++a) {
    for (int b = a + nearest; b < kLinkCount; ++b) {
      measure_pair(configuration, arm, a, b);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  wanted = argc > 1 ? argv[1] : nullptr;
  if (!trees.open()) {
    return 1;
  }
  for (const Configuration& configuration : kConfigurations) {
    check(configuration);
    // Neighbours are tested once: they intersect in every configuration.
    measure_pairs(configuration, &configuration == kConfigurations ? 1 : 2);
  }
  return failed ? 1 : 0;
}
