#include "evaluate/run.hpp"

#include <time.h>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "bake/baked_tree.hpp"
#include "evaluate/count_query.hpp"
#include "flashbvh/traversal/traversals.hpp"

namespace flashbvh::tool {

/// One tree in both layouts.
template <class Index>
struct BothLayouts {
  template <Layout layout>
  using Baked = bake::BakedTree<Index, layout>;
  std::tuple<Baked<Layout::pre_indexed>, Baked<Layout::post_indexed>> baked;

  BothLayouts(const bake::BuildTree& tree, const bake::LatticeMesh& mesh)
      : baked(bake::lay_out<Index, Layout::pre_indexed>(tree, mesh),
              bake::lay_out<Index, Layout::post_indexed>(tree, mesh)) {}

  template <Layout layout>
  auto view() const {
    return std::get<Baked<layout>>(baked).view();
  }
};

/// An object's tree of the paper, split at the median, and its tree of `flashbvh bake`; both have
/// one triangle per leaf.
struct Trees {
  std::optional<BothLayouts<std::uint16_t>> narrow;  ///< absent if the tree needs 32 bits
  BothLayouts<std::uint32_t> wide;
  bake::BakedTree<std::uint32_t, Layout::post_indexed> by_default;

  explicit Trees(const bake::LatticeMesh& mesh) : Trees(mesh, bake::build_median(mesh, 1)) {}
  Trees(const bake::LatticeMesh& mesh, const bake::BuildTree& median)
      : wide(median, mesh),
        by_default(bake::lay_out<std::uint32_t, Layout::post_indexed>(bake::build_default(mesh, 1),
                                                                      mesh)) {
    if (bake::fits_index<std::uint16_t>(median, mesh)) {
      narrow.emplace(median, mesh);
    }
  }
};

const Trees& Objects::get(const scene::PaperObject& object) {
  std::shared_ptr<const Trees>& trees = trees_[name_of(object)];
  if (!trees) {
    trees = std::make_shared<Trees>(make_mesh(object));
  }
  return *trees;
}

namespace {

/// The pose is read again each time, so that the compiler cannot remove repetitions.
struct VolatilePose {
  volatile std::int32_t x, y, z;
  Pose now() const { return Pose::translated(x, y, z); }
};

template <class Traversal>
Row make_row(const std::string& name, const typename Traversal::Tree& a,
             const typename Traversal::Tree& b, const Point& translation) {
  return {name, {}, {}, [a, b, translation](std::uint32_t repetitions) {
            const VolatilePose pose = {translation.x, translation.y, translation.z};
            scene::WalkStart<Traversal> start(a, b);
            QueryStats counts = {0, 0, 0, 0};
            for (std::uint32_t i = 0; i < repetitions; ++i) {
              counts = scene::count_query<Traversal>(a, b, pose.now(), start);
            }
            return counts;
          }};
}

/// A row for each traversal, in the layout of the paper.
template <class Index>
std::vector<Row> paper_rows(const BothLayouts<Index>& a, const BothLayouts<Index>& b,
                            const Point& translation) {
  std::vector<Row> rows;
  for_each_traversal([&](auto named) {
    constexpr Layout layout = decltype(named)::kLayout;
    using Traversal = typename decltype(named)::template On<Index, layout>;
    rows.push_back(make_row<Traversal>(named.name, a.template view<layout>(),
                                       b.template view<layout>(), translation));
  });
  return rows;
}

std::vector<Row> rows_of(const scene::Setup& setup, const Trees& a, const Trees& b) {
  std::vector<Row> rows = a.narrow && b.narrow ? paper_rows(*a.narrow, *b.narrow, setup.translation)
                                               : paper_rows(a.wide, b.wide, setup.translation);
  rows.push_back(make_row<Ranked<Mesh32>>("ranked, default tree", a.by_default.view(),
                                          b.by_default.view(), setup.translation));
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

bool SetupResult::rows_agree() const {
  const QueryStats& first = rows[0].counts;
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    return row.counts.visits != 0 && row.counts.triangle_pairs == first.triangle_pairs &&
           row.counts.leaf_pairs == first.leaf_pairs;
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
      const double start = processor_seconds();
      row.query(result.repetitions);
      row.seconds.push_back(processor_seconds() - start);
    }
  }
  return result;
}

}  // namespace flashbvh::tool
