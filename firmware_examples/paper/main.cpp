// The paper's five traversals and `ranked` on an object and its copy, moved and turned: what each
// visits, and what it costs on this core. All find the same pairs of triangles.
//
// As in the paper, the tree is split at the median, with one triangle per leaf, and leaves reject
// by their boxes alone: BoxIntersection.
#include <flashbvh/float.hpp>
#include <flashbvh/query.hpp>
#include <flashbvh/traversal/traversals.hpp>

#include "insn.hpp"
#include "post.fbvh.h"
#include "pre.fbvh.h"
#include "stack.hpp"
#include "text.hpp"

using namespace flashbvh;

namespace {

const auto pre = view_unchecked<PreMeshWithLevels>(pre_image);
const auto post = view_unchecked<MeshWithLevels>(post_image);

StackEntry<uint16_t> entries[stack_entries(post_STACK_NEED, post_STACK_NEED)];

/// Where a query begins: nothing, or the stack of a traversal with a stack.
template <class Cursor>
Cursor start(const Cursor*) {
  return Cursor();
}
PairStack<uint16_t> start(const PairStack<uint16_t>*) {
  return PairStack<uint16_t>(entries, sizeof entries / sizeof entries[0]);
}

struct Result {
  Status status;
  uint32_t pairs;
  uint32_t sum;  ///< of all pairs, in any order
  QueryStats stats;
};

/// Not inlined: its frame is part of the stack.
template <class Traversal>
[[gnu::noinline]] Result run(const typename Traversal::Tree& ring, const Pose& pose) {
  using PaperQuery = Query<Traversal, detail::BoxIntersection>;
  PaperQuery query(ring, ring, pose, start(static_cast<typename Traversal::Cursor*>(nullptr)));
  uint32_t sum = 0;
  const RunResult end = query.run(UINT32_MAX, [&](const typename PaperQuery::Pair& pair) {
    sum += (uint32_t{pair.a} * 40503u + pair.b) * 2654435761u;
    return true;
  });
  return {end.status, end.count, sum, query.stats()};
}

/// Prints a row, and returns whether its pairs are those of `ranked`.
template <class Traversal>
bool show(const char* name, const typename Traversal::Tree& ring, const Pose& pose) {
  Result result{};
  const uint32_t instructions = port::instructions_of([&] { result = run<Traversal>(ring, pose); });
  const uint32_t stack = port::stack_of([&] { result = run<Traversal>(ring, pose); });
  port::print(name, result.stats.visits, " visits, ", result.stats.overlaps, " overlaps, ",
              result.stats.leaf_pairs, " leaf pairs, ");
  port::print(result.pairs, " pairs; ", instructions, " instructions, ", stack, " bytes\n");
  const Result expected = run<Ranked<Mesh>>(post, pose);
  return result.status == Status::done && result.pairs == expected.pairs &&
         result.sum == expected.sum;
}

bool show_all(const char* title, const Pose& pose) {
  port::print(title, "\n");
  bool agree = show<VolumeStack>("volume-stack      ", pre, pose);
  agree = show<AlternatingStack>("alternating-stack ", pre, pose) && agree;
  agree = show<Stackless>("stackless         ", pre, pose) && agree;
  agree = show<StacklessPost>("stackless-post    ", post, pose) && agree;
  agree = show<Leaf>("leaf              ", pre, pose) && agree;
  return show<Ranked<Mesh>>("ranked            ", post, pose) && agree;
}

}  // namespace

int main() {
  port::print("two rings of ", post_TRIANGLE_COUNT, " triangles; a stack of ",
              sizeof entries / sizeof entries[0], " pairs\n");
  const bool moved = show_all("moved:", pose_of({1, 0, 0, 0}, {21, 5, 3}, post_CELLS_PER_UNIT));
  const bool turned =
      show_all("moved and turned:", pose_of({0.8f, 0.6f, 0, 0}, {21, 5, 3}, post_CELLS_PER_UNIT));
  return moved && turned ? 0 : 1;
}
