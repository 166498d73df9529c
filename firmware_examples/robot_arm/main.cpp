// The links of a KUKA KR5 arm against each other, with every traversal, on a microcontroller.
//
// Prints a line per pair of links, offset and algorithm:
//     result A B x y z algorithm visits overlaps leaf_pairs triangle_pairs stack
// x, y and z in metres: B moved in A's frame; stack in bytes: what a call of run() needs at most.
// The query objects are the caller's. tools/demo.sh compares the lines with what the host finds.
#include <flashbvh/flashbvh.hpp>
#include <flashbvh/traversal/alternating_stack.hpp>
#include <flashbvh/traversal/leaf.hpp>
#include <flashbvh/traversal/ranked_stack.hpp>
#include <flashbvh/traversal/stackless.hpp>
#include <flashbvh/traversal/stackless_post.hpp>
#include <flashbvh/traversal/volume_stack.hpp>

#include "links.hpp"
#include "stack.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

/// A pair of links and where the second one is.
struct Case {
  const Link& a;
  const Link& b;
  const char* metres;  ///< the offset as text, for the host
  Pose pose;
};

#define CASE(a, b, x, y, z) \
  { robot::a, robot::b, #x " " #y " " #z, Pose::translated(cells(x), cells(y), cells(z)) }

const Case kCases[] = {
    CASE(palm, wrist, 0.3, 0, 0),            // separated
    CASE(palm, wrist, 0, 0, 0.0723),         // just touching
    CASE(palm, wrist, 0.01, 0.02, 0.01),     // intersecting
    CASE(forearm, bicep, 0, 0, 1),           // separated
    CASE(forearm, bicep, 0, 0, 0.15),        // close
    CASE(forearm, bicep, 0, 0, 0.14),        // intersecting
    CASE(base_link, shoulder, -0.5, 0, 0),   // separated
    CASE(base_link, shoulder, 0, 0, 0.225),  // close
    CASE(base_link, shoulder, 0, 0, 0.203),  // as mounted: they share the bearing
    CASE(elbow, forearm, 0, 0.08, 0),        // separated
    CASE(elbow, forearm, 0, 0, 0),           // intersecting
};

unsigned deepest_stack = 0;
bool failed = false;

void print_result(const Case& what, const char* algorithm, const Counts& counts, Status status,
                  uint32_t stack) {
  deepest_stack = stack > deepest_stack ? stack : deepest_stack;
  failed = failed || status != Status::done;
  port::print("result ", what.a.name, " ", what.b.name, " ", what.metres, " ", algorithm, " ",
              counts.visits, " ", counts.overlaps, " ", counts.leaf_pairs, " ");
  port::print(counts.triangle_pairs, " ", stack, "\n");
}

/// Runs a query to its end, 100 visits at a time, as a control loop would.
template <class Query>
void run_to_end(const Case& what, const char* algorithm, Query& query) {
  typename Query::Pair found[4];
  Step step{};
  uint32_t stack = 0;
  do {
    const uint32_t used = port::stack_of([&] { step = query.run(100, found); });
    stack = used > stack ? used : stack;
  } while (step.status == Status::suspended || step.status == Status::full);
  print_result(what, algorithm, query.counts(), step.status, stack);
}

template <class Traversal>
void run_stackless(const Case& what, const char* algorithm, const typename Traversal::Tree& a,
                   const typename Traversal::Tree& b) {
  Query<Traversal> query(a, b, what.pose);
  run_to_end(what, algorithm, query);
}

template <class Traversal>
void run_with_stack(const Case& what, const char* algorithm) {
  PairCursor<uint16_t> entries[stack_entries(robot::kStackNeed, robot::kStackNeed)];
  Query<Traversal> query(*what.a.post, *what.b.post, what.pose,
                         {entries, sizeof entries / sizeof entries[0]});
  run_to_end(what, algorithm, query);
}

bool open(const Link& link, LevelledPreTree& tree) {
  const Status status = open_image(link.image, link.image_bytes(), tree);
  if (status != Status::done) {
    port::print("error: the image of ", link.name, " does not open: status ",
                static_cast<unsigned>(status), "\n");
    failed = true;
  }
  return status == Status::done;
}

/// The pre-indexed trees are not compiled in: their images lie in flash and are opened in place.
void run_on_images(const Case& what) {
  LevelledPreTree a;
  LevelledPreTree b;
  if (!open(what.a, a) || !open(what.b, b)) {
    return;
  }
  run_stackless<Stackless>(what, "stackless", a, b);
}

}  // namespace

int main() {
  for (const Case& what : kCases) {
    run_with_stack<VolumeStack<PostTree>>(what, "volume-stack");
    run_with_stack<AlternatingStack<LevelledPostTree>>(what, "alternating-stack");
    run_on_images(what);
    run_stackless<StacklessPost>(what, "stackless-post", *what.a.post, *what.b.post);
    run_stackless<Leaf<PostTree>>(what, "leaf", *what.a.post, *what.b.post);
    run_stackless<Ranked<PostTree>>(what, "ranked", *what.a.post, *what.b.post);
    run_with_stack<RankedStack<PostTree>>(what, "ranked-stack");
  }
  port::print("stack ", deepest_stack, "\n");
  return failed ? 1 : 0;
}
