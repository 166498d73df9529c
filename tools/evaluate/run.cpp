#include "evaluate/run.hpp"

#include <time.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "bake/baked_tree.hpp"
#include "evaluate/count_query.hpp"
#include "reference/traversals.hpp"

namespace flashbvh::tool {

/// One tree in both layouts.
template <class Index>
struct BothLayouts {
  bake::BakedTree<Index, Layout::pre_indexed> pre;
  bake::BakedTree<Index, Layout::post_indexed> post;

  BothLayouts(const bake::BuildTree& tree, const bake::LatticeMesh& mesh)
      : pre(bake::lay_out<Index, Layout::pre_indexed>(tree, mesh)),
        post(bake::lay_out<Index, Layout::post_indexed>(tree, mesh)) {}

  template <Layout layout>
  auto view() const {
    if constexpr (layout == Layout::pre_indexed) {
      return pre.view();
    } else {
      return post.view();
    }
  }
};

/// An object's tree of the paper, split at the median, and its tree of `flashbvh bake`; both have
/// one triangle per leaf.
struct Trees {
  bake::LatticeMesh mesh;
  bake::BuildTree median = bake::build_median(mesh, 1);
  bake::BuildTree by_default = bake::build_default(mesh, 1);
  std::optional<BothLayouts<std::uint16_t>> narrow;  ///< absent if the tree needs 32 bits
  BothLayouts<std::uint32_t> wide{median, mesh};
  bake::BakedTree<std::uint32_t, Layout::post_indexed> baked_by_default =
      bake::lay_out<std::uint32_t, Layout::post_indexed>(by_default, mesh);

  explicit Trees(const scene::PaperObject& object) : mesh(make_mesh(object)) {
    if (bake::fits_index<std::uint16_t>(median, mesh)) {
      narrow.emplace(median, mesh);
    }
  }
};

Objects::Objects() = default;
Objects::~Objects() = default;

const Trees& Objects::get(const scene::PaperObject& object) {
  std::unique_ptr<Trees>& trees = trees_[name_of(object)];
  if (!trees) {
    trees = std::make_unique<Trees>(object);
  }
  return *trees;
}

namespace {

/// The pose is read again each time, so that the compiler cannot remove repetitions.
struct VolatilePose {
  volatile std::int32_t x, y, z;
  Pose now() const { return Pose::translated(x, y, z); }
};

template <class Traversal, class Predicate>
Row make_row(const std::string& name, Leaves leaves, const typename Traversal::Tree& a,
             const typename Traversal::Tree& b, const Point& translation) {
  return {name, leaves, {}, {}, [a, b, translation](std::uint32_t repetitions) {
            const VolatilePose pose = {translation.x, translation.y, translation.z};
            scene::WalkStart<Traversal> start(a, b);
            QueryStats counts = {0, 0, 0, 0};
            std::uint32_t found = 0;
            for (std::uint32_t i = 0; i < repetitions; ++i) {
              counts = scene::count_query<Traversal, Predicate>(a, b, pose.now(), start, found);
            }
            return counts;
          }};
}

/// Adds a row for each traversal order, in the layout of the paper.
template <class Predicate, class Index>
void add_orders(std::vector<Row>& rows, Leaves leaves, const BothLayouts<Index>& a,
                const BothLayouts<Index>& b, const Point& translation) {
  for_each_traversal([&](auto named) {
    constexpr Layout layout = decltype(named)::kLayout;
    using Traversal = typename decltype(named)::template On<Index, layout>;
    const char* const suffix = leaves == Leaves::shapes ? ", leaves as shapes" : "";
    rows.push_back(make_row<Traversal, Predicate>(std::string(named.name) + suffix, leaves,
                                                  a.template view<layout>(),
                                                  b.template view<layout>(), translation));
  });
}

Row best_rule_row(const std::string& name, const bake::BuildTree& a, const bake::BuildTree& b,
                  const Point& translation) {
  return {name, Leaves::none, {}, {}, [&a, &b, translation](std::uint32_t /*repetitions*/) {
            const std::uint64_t visits = best_rule_visits(a, b, translation);
            return QueryStats{static_cast<std::uint32_t>(visits), 0, 0, 0};
          }};
}

template <class Index>
void add_paper_rows(std::vector<Row>& rows, const scene::Setup& setup, const Trees& trees_a,
                    const Trees& trees_b, const BothLayouts<Index>& a,
                    const BothLayouts<Index>& b) {
  add_orders<BoxIntersection>(rows, Leaves::boxes, a, b, setup.translation);
  if (std::max(setup.a.faces(), setup.b.faces()) <= kBestRuleFaces) {
    rows.push_back(best_rule_row("best rule", trees_a.median, trees_b.median, setup.translation));
  }
  add_orders<Intersection>(rows, Leaves::shapes, a, b, setup.translation);
}

std::vector<Row> rows_of(const scene::Setup& setup, const Trees& a, const Trees& b) {
  std::vector<Row> rows;
  if (a.narrow && b.narrow) {
    add_paper_rows(rows, setup, a, b, *a.narrow, *b.narrow);
  } else {
    add_paper_rows(rows, setup, a, b, a.wide, b.wide);
  }
  rows.push_back(make_row<Ranked<Mesh32>, BoxIntersection>(
      "ranked, default tree", Leaves::boxes, a.baked_by_default.view(), b.baked_by_default.view(),
      setup.translation));
  rows.push_back(
      best_rule_row("best rule, default tree", a.by_default, b.by_default, setup.translation));
  return rows;
}

/// The time of this process alone, as in the paper; other work of the machine does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Times times_of(const std::vector<double>& samples) {
  const auto count = static_cast<double>(samples.size());
  const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / count;
  double squares = 0;
  for (const double sample : samples) {
    squares += (sample - mean) * (sample - mean);
  }
  return {*least, *most, mean, std::sqrt(squares / count)};
}

const Row* SetupResult::row(const std::string& name) const {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& candidate) { return candidate.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

bool SetupResult::rows_agree() const {
  const QueryStats& first = rows[0].counts;
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    const QueryStats& counts = row.counts;
    return counts.visits != 0 &&
           (row.leaves == Leaves::none || counts.triangle_pairs == first.triangle_pairs) &&
           (row.leaves != Leaves::boxes || counts.leaf_pairs == first.leaf_pairs);
  });
}

SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects) {
  const double repetitions = std::round(setup.repetitions * effort.repetitions_scale);
  SetupResult result = {&setup, static_cast<std::uint32_t>(std::max(1.0, repetitions)),
                        rows_of(setup, objects.get(setup.a), objects.get(setup.b))};
  for (Row& row : result.rows) {
    row.counts = row.query(1);
  }
  for (std::uint32_t round = 0; round < effort.rounds; ++round) {
    for (Row& row : result.rows) {
      if (row.leaves != Leaves::none) {
        const double start = processor_seconds();
        row.query(result.repetitions);
        row.seconds.push_back(processor_seconds() - start);
      }
    }
  }
  return result;
}

}  // namespace flashbvh::tool
