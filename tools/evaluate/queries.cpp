#include "evaluate/queries.hpp"

#include <type_traits>

#include "flashbvh/query.hpp"
#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/ranked_stack.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/volume_stack.hpp"

namespace flashbvh::tool {
namespace {

/// Few enough that no count of one run wraps.
constexpr std::uint32_t kVisitsPerRun = 1u << 24;

void add(WideCounts& sum, const Counts& now, const Counts& before) {
  sum.visits += now.visits - before.visits;
  sum.overlaps += now.overlaps - before.overlaps;
  sum.leaf_pairs += now.leaf_pairs - before.leaf_pairs;
  sum.triangle_pairs += now.triangle_pairs - before.triangle_pairs;
}

template <class QueryType>
Answer run_to_end(QueryType query, bool first) {
  Answer answer;
  answer.status = query.status();
  while (answer.status == Status::suspended) {
    const Counts before = query.counts();
    answer.status = query.run(kVisitsPerRun, [&](const typename QueryType::Pair& pair) {
      answer.pairs.push_back({pair.a, pair.b});
      return !first;
    });
    add(answer.counts, query.counts(), before);
  }
  if (answer.status == Status::full) {
    answer.status = Status::done;  // the first pair is all that was asked for
  }
  return answer;
}

template <class Cursor>
struct IsStack : std::false_type {};
template <class Index>
struct IsStack<PairStack<Index>> : std::true_type {};

template <class Traversal>
Answer run(const typename Traversal::Tree& a, const typename Traversal::Tree& b, const Pose& pose,
           bool first) {
  using Cursor = typename Traversal::Cursor;
  if constexpr (IsStack<Cursor>::value) {
    const std::uint32_t count = stack_entries(a.stack_need, b.stack_need);
    std::vector<typename Cursor::Entry> entries(count);
    return run_to_end(Query<Traversal>(a, b, pose, Cursor(entries.data(), count)), first);
  } else {
    return run_to_end(Query<Traversal>(a, b, pose), first);
  }
}

template <class Levelled>
Answer run_named(const Levelled& a, const Levelled& b, const Pose& pose,
                 const std::string& algorithm, bool first) {
  using Plain = Tree<typename Levelled::Index, Levelled::kLayout>;
  if (algorithm == "volume-stack") {
    return run<VolumeStack<Plain>>(a, b, pose, first);
  }
  if (algorithm == "alternating-stack") {
    return run<AlternatingStack<Levelled>>(a, b, pose, first);
  }
  if (algorithm == "leaf") {
    return run<Leaf<Plain>>(a, b, pose, first);
  }
  if constexpr (Levelled::kLayout == Layout::post_indexed) {
    if (algorithm == "ranked") {
      return run<Ranked<Plain>>(a, b, pose, first);
    }
    if (algorithm == "ranked-stack") {
      return run<RankedStack<Plain>>(a, b, pose, first);
    }
  }
  return run<AlternatingStackless<Levelled>>(a, b, pose, first);
}

}  // namespace

const std::vector<std::string>& algorithm_names() {
  static const std::vector<std::string> names = {
      "ranked",    "ranked-stack",   "volume-stack", "alternating-stack",
      "stackless", "stackless-post", "leaf"};
  return names;
}

const char* default_algorithm(Layout layout) {
  return layout == Layout::post_indexed ? "ranked" : "stackless";
}

bool runs_on(const std::string& algorithm, Layout layout) {
  if (algorithm == "stackless") {
    return layout == Layout::pre_indexed;
  }
  if (algorithm == "stackless-post" || algorithm == "ranked" || algorithm == "ranked-stack") {
    return layout == Layout::post_indexed;
  }
  return true;
}

Answer collide(const AnyTree& a, const AnyTree& b, const Pose& pose, const std::string& algorithm,
               bool first) {
  return std::visit(
      [&](const auto& tree_a) {
        using Levelled = std::decay_t<decltype(tree_a)>;
        return run_named(tree_a, std::get<Levelled>(b), pose, algorithm, first);
      },
      a);
}

}  // namespace flashbvh::tool
