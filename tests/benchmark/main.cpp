// The paper's evaluation, section 9, on a microcontroller: instructions instead of seconds.
//
// Ends with 1 if the algorithms disagree about a setup, or a query does not finish.
#include "measure.hpp"
#include "report.hpp"
#include "setups.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace benchmark {
namespace {

/// Setups that end at the roots say nothing about the loop.
constexpr uint32_t kMostVisitsOfSeparated = 10;

TranslatedBound overlap_of(const Setup& setup) {
  int32_t t[3];
  for (int i = 0; i < 3; ++i) {
    t[i] = setup.translation[i] + setup.b.pre->origin[i] - setup.a.pre->origin[i];
  }
  return {t[0], t[1], t[2]};
}

template <Layout layout>
const LevelledMesh<uint16_t, layout>& tree_of(const Object& object) {
  if constexpr (layout == Layout::pre_indexed) {
    return *object.pre;
  } else {
    return *object.post;
  }
}

/// Each algorithm on the layout that it has on the host, too.
void measure_rows(const Setup& setup, Row (&rows)[kRows]) {
  const TranslatedBound overlap = overlap_of(setup);
  uint32_t next = 0;
  for_each_traversal([&](auto traversal) {
    using Order = typename decltype(traversal)::template On<uint16_t, decltype(traversal)::kLayout>;
    const auto& a = tree_of<Order::Tree::kLayout>(setup.a);
    const auto& b = tree_of<Order::Tree::kLayout>(setup.b);
    rows[next++] = {traversal.name, measure_walk<Order>(a, b, overlap)};
  });
}

bool agree(const Row (&rows)[kRows]) {
  for (const Row& row : rows) {
    if (row.walked.visits == 0 || row.walked.leaf_overlaps != rows[0].walked.leaf_overlaps) {
      return false;
    }
  }
  return true;
}

void add_to(Row (&sums)[kRows], const Row (&rows)[kRows]) {
  for (uint32_t i = 0; i < kRows; ++i) {
    sums[i].algorithm = rows[i].algorithm;
    sums[i].walked.visits += rows[i].walked.visits;
    sums[i].walked.overlaps += rows[i].walked.overlaps;
    sums[i].walked.leaf_overlaps += rows[i].walked.leaf_overlaps;
    sums[i].walked.instructions += rows[i].walked.instructions;
  }
}

bool run_queries(const Setup& setup, const Row (&rows)[kRows]) {
  const Pose pose =
      Pose::translated(setup.translation[0], setup.translation[1], setup.translation[2]);
  const Queried ranked = measure_query<Ranked<PostMesh>>(*setup.a.post, *setup.b.post, pose);
  const Queried volume = measure_query<VolumeStack<PreMesh>>(*setup.a.pre, *setup.b.pre, pose);
  report_query(setup, "ranked", ranked);
  report_query(setup, "volume-stack", volume);
  return ranked.status == Status::done && volume.status == Status::done &&
         ranked.counts.triangle_pairs == volume.counts.triangle_pairs &&
         ranked.counts.leaf_pairs == rows[kFirstRow].walked.leaf_overlaps &&
         volume.counts.leaf_pairs == rows[kFirstRow].walked.leaf_overlaps;
}

/// The stack algorithms trust their array, so it is checked before they run.
bool stack_suffices(const Setup& setup) {
  return stack_entries(setup.a.pre->stack_need, setup.b.pre->stack_need) <= kStackEntries;
}

bool run_setup(const Setup& setup, Row (&sums)[kRows]) {
  if (!stack_suffices(setup)) {
    port::print(setup.head.name, ": the array for the stack is too small\n");
    return false;
  }
  Row rows[kRows];
  measure_rows(setup, rows);
  report_setup(setup, rows);
  if (rows[kFirstRow].walked.visits > kMostVisitsOfSeparated) {
    add_to(sums, rows);
  }
  if (!run_queries(setup, rows) || !agree(rows)) {
    port::print(setup.head.name, ": the algorithms found different overlaps\n");
    return false;
  }
  return true;
}

bool run_all() {
  port::put("core " FLASHBVH_CORE "\n");
  Row sums[kRows] = {};
  bool good = true;
  for (const Setup* setup = kSetups; setup->head.name != nullptr; ++setup) {
    good = run_setup(*setup, sums) && good;
  }
  if (sums[kFirstRow].walked.visits != 0) {
    report_totals(sums);
  }
  for (const Head* head = kLeftOut; head->name != nullptr; ++head) {
    report_left_out(*head);
  }
  return good;
}

}  // namespace
}  // namespace benchmark

int main() {
  return benchmark::run_all() ? 0 : 1;
}
