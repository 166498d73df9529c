// The links of a KUKA KR5 arm against each other, with every traversal, on a microcontroller.
//
// Prints a line per pair of links, offset and algorithm:
//     result A B x y z algorithm visits overlaps leaf_pairs triangle_pairs stack
// x, y and z in metres: B moved in A's frame; stack in bytes, with the query object and, for the
// stack traversals, their array. tools/demo.sh compares the lines with what the host finds.
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
  {robot::a, robot::b, #x " " #y " " #z, Pose::translated(cells(x), cells(y), cells(z))}

const Case kCases[] = {
    CASE(palm, wrist, 0.3, 0, 0),            // separated
    CASE(palm, wrist, 0, 0, 0.075),          // close
    CASE(palm, wrist, 0.01, 0.02, 0.01),     // intersecting
    CASE(forearm, bicep, 0, 0, 1),           // separated
    CASE(forearm, bicep, 0.1, -0.1, 0),      // close
    CASE(forearm, bicep, 0.02, 0, 0.01),     // intersecting
    CASE(base_link, shoulder, -0.5, 0, 0),   // separated
    CASE(base_link, shoulder, 0, 0, 0.203),  // as mounted
    CASE(base_link, shoulder, 0, 0, 0.1),    // intersecting
    CASE(elbow, forearm, 0, 0.13, 0),        // close
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
Status run_to_end(Query& query) {
  typename Query::Pair found[4];
  Step step;
  do {
    step = query.run(100, found);
  } while (step.status == Status::suspended || step.status == Status::full);
  return step.status;
}

template <class Traversal>
void run_stackless(const Case& what, const char* algorithm, const typename Traversal::Tree& a,
                   const typename Traversal::Tree& b) {
  Counts counts{};
  Status status = Status::done;
  const uint32_t stack = port::stack_of([&] {
    Query<Traversal> query(a, b, what.pose);
    status = run_to_end(query);
    counts = query.counts();
  });
  print_result(what, algorithm, counts, status, stack);
}

template <class Traversal>
void run_with_stack(const Case& what, const char* algorithm) {
  Counts counts{};
  Status status = Status::done;
  const uint32_t stack = port::stack_of([&] {
    PairCursor<uint16_t> entries[stack_entries(robot::kStackNeed, robot::kStackNeed)];
    Query<Traversal> query(*what.a.post, *what.b.post, what.pose,
                           {entries, sizeof entries / sizeof entries[0]});
    status = run_to_end(query);
    counts = query.counts();
  });
  print_result(what, algorithm, counts, status, stack);
}

/// The pre-indexed trees are not compiled in: their images lie in flash and are opened in place.
void run_on_images(const Case& what) {
  LevelledPreTree a;
  LevelledPreTree b;
  if (open_image(what.a.image, what.a.image_bytes(), a) != Status::done ||
      open_image(what.b.image, what.b.image_bytes(), b) != Status::done) {
    port::print("error: the image of ", what.a.name, " or ", what.b.name, " does not open\n");
    failed = true;
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
