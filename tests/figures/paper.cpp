// The paper's evaluation, section 9, on a microcontroller: instructions instead of seconds of each
// algorithm in each setup of this image, as paper.SETUP.ALGORITHM.WHAT.
//
// Exits with 1 if the algorithms disagree about a setup, a query does not finish, or `ranked` needs
// 0.85 of the instructions of `volume-stack` in a setup, or 1.02 of `ranked-stack` in all setups.
#include <string.h>

#include "reference/levels.hpp"
#include "report.hpp"
#include "setups.hpp"
#include "support/at_roots.hpp"
#include "support/walk.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace benchmark {
namespace {

/// Setups with fewer visits do not measure the loop.
constexpr uint32_t kMostVisitsOfSeparated = 10;
/// Stack entries for every setup; the program checks this: stack traversals trust their array.
constexpr uint32_t kStackEntries = 64;

struct Counted {
  Status status;
  QueryStats counts;
  uint32_t instructions;
};

template <class Traversal>
typename Traversal::Cursor start() {
  static PairCursor<uint16_t> entries[kStackEntries];
  return test::at_roots<Traversal>(entries, kStackEntries);
}

/// Continues at each pair of leaves. Holds the count itself, so that a walk needs only one address.
struct LeafCounter {
  mutable uint32_t count = 0;
  bool operator()(uint32_t /*node_a*/, uint32_t /*node_b*/, const Progress& /*progress*/) const {
    ++count;
    return true;
  }
};

/// A walk over boxes alone, from its start to its end, counting pairs of leaves.
template <class Traversal>
__attribute__((noinline)) Counted measure_walk(const typename Traversal::Tree& a,
                                               const typename Traversal::Tree& b,
                                               const TranslatedBoxTest& overlap) {
  Counted walked{};
  const LeafCounter leaf_pairs;
  walked.instructions = port::instructions_of([&] {
    auto cursor = start<Traversal>();
    walked.counts = test::walk_from<Traversal>(a, b, overlap, cursor, leaf_pairs).counts;
  });
  walked.counts.leaf_pairs = leaf_pairs.count;
  return walked;
}

/// Makes a query and runs it to its end, testing the triangles of each pair of leaves.
template <class Traversal>
__attribute__((noinline)) Counted measure_query(const typename Traversal::Tree& a,
                                                const typename Traversal::Tree& b,
                                                const Pose& pose) {
  using Query = flashbvh::Query<Traversal, BoxIntersection>;
  const auto every_pair = [](const typename Query::Pair&) { return true; };
  Counted result{};
  result.instructions = port::instructions_of([&] {
    Query query(a, b, pose, start<Traversal>());
    result.status = query.run(UINT32_MAX, every_pair).status;
  });
  // Counts come from another run: a caller of the first run would not copy them.
  Query query(a, b, pose, start<Traversal>());
  (void)query.run(UINT32_MAX, every_pair);
  result.counts = query.stats();
  return result;
}

/// A setup's objects, in the traversals' formats.
struct Trees {
  PreMeshWithLevels pre;
  MeshWithLevels post;

  explicit Trees(const Object& object)
      : pre(view_with_levels<PreMeshWithLevels>(object.pre)),
        post(view_with_levels<MeshWithLevels>(object.post)) {}

  template <Layout layout>
  const auto& of() const {
    if constexpr (layout == Layout::pre_indexed) {
      return pre;
    } else {
      return post;
    }
  }
};

uint64_t sum_of_ranked;
uint64_t sum_of_ranked_stack;

/// Whether `a` is less than `percent` of `b`.
bool below(uint64_t a, uint32_t percent, uint64_t b) {
  return a * 100 < b * percent;
}

/// Walks of each algorithm, on the layout that it uses on the host. The first one is volume-stack,
/// to which the others are compared.
bool measure_walks(const Setup& setup, const Trees& a, const Trees& b, uint32_t& leaf_pairs) {
  int32_t t[3];
  for (int i = 0; i < 3; ++i) {
    t[i] = setup.translation[i] + b.pre.origin[i] - a.pre.origin[i];
  }
  const TranslatedBoxTest overlap(t[0], t[1], t[2]);
  bool right = true;
  bool counts_for_loop = false;
  uint32_t of_volume = 0;
  for_each_traversal([&](auto traversal) {
    using Traversal =
        typename decltype(traversal)::template On<uint16_t, decltype(traversal)::kLayout>;
    constexpr Layout kLayout = Traversal::Tree::kLayout;
    const Counted walked = measure_walk<Traversal>(a.of<kLayout>(), b.of<kLayout>(), overlap);
    const QueryStats& counts = walked.counts;
    const char* const set = setup.head.name;
    figures::print_count({{"paper", set, traversal.name, "visits"}}, counts.visits);
    figures::print_count({{"paper", set, traversal.name, "overlaps"}}, counts.overlaps);
    figures::print_count({{"paper", set, traversal.name, "leaf_overlaps"}}, counts.leaf_pairs);
    figures::print_figure({{"paper", set, traversal.name, "walk"}}, walked.instructions);
    if (of_volume == 0) {
      of_volume = walked.instructions;
      leaf_pairs = counts.leaf_pairs;
      counts_for_loop = counts.visits > kMostVisitsOfSeparated;
    }
    right = right && counts.visits != 0 && counts.leaf_pairs == leaf_pairs;
    if (counts_for_loop) {
      figures::add_quotient({{"paper", "visit", traversal.name}}, walked.instructions,
                            counts.visits);
      const bool is_ranked = strcmp(traversal.name, "ranked") == 0;
      right = right && (!is_ranked || below(walked.instructions, 85, of_volume));
      sum_of_ranked += is_ranked ? walked.instructions : 0;
      sum_of_ranked_stack += strcmp(traversal.name, "ranked-stack") == 0 ? walked.instructions : 0;
    }
  });
  return right;
}

bool measure_queries(const Setup& setup, const Trees& a, const Trees& b, uint32_t leaf_pairs) {
  const Pose pose =
      Pose::translated(setup.translation[0], setup.translation[1], setup.translation[2]);
  const Counted ranked = measure_query<Ranked<Mesh>>(a.post, b.post, pose);
  const Counted volume = measure_query<VolumeStack<PreMesh>>(a.pre, b.pre, pose);
  const char* const set = setup.head.name;
  figures::print_count({{"paper", set, "geometry_overlaps"}}, ranked.counts.triangle_pairs);
  figures::print_figure({{"paper", set, "ranked", "query"}}, ranked.instructions);
  figures::print_figure({{"paper", set, "volume-stack", "query"}}, volume.instructions);
  if (ranked.counts.visits == 1) {
    figures::add_figure({{"paper", "separated"}}, ranked.instructions);
  }
  return ranked.status == Status::done && volume.status == Status::done &&
         ranked.counts.triangle_pairs == volume.counts.triangle_pairs &&
         ranked.counts.leaf_pairs == leaf_pairs && volume.counts.leaf_pairs == leaf_pairs;
}

bool measure_setup(const Setup& setup) {
  port::print("Table ", setup.head.table, ": ", setup.head.name, "\n");
  uint32_t leaf_pairs = 0;
  const Trees a(setup.a);
  const Trees b(setup.b);
  const bool right = stack_entries(a.pre.stack_need, b.pre.stack_need) <= kStackEntries &&
                     measure_walks(setup, a, b, leaf_pairs) &&
                     measure_queries(setup, a, b, leaf_pairs);
  port::put(right ? "" : "That is wrong\n");
  return right;
}

}  // namespace
}  // namespace benchmark

int main() {
  using namespace benchmark;
  bool right = true;
  for (const Setup* setup = kSetups; setup->head.name != nullptr; ++setup) {
    right = measure_setup(*setup) && right;
  }
  right = right && (sum_of_ranked == 0 || below(sum_of_ranked, 102, sum_of_ranked_stack));
  for (const Head* head = kLeftOut; head->name != nullptr; ++head) {
    port::print("Too large for the flash of this board: table ", head->table, ", ", head->name,
                "\n");
  }
  return figures::print_all(nullptr, right);
}
