#include "evaluate/run.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <numeric>

#include "evaluate/best_rule.hpp"
#include "evaluate/count_query.hpp"
#include "flashbvh/paper/traversals.hpp"

namespace flashbvh::tool {
namespace {

/// The pose is read anew each time, so that no repetition can be optimised away.
struct VolatilePose {
  volatile std::int32_t x, y, z;
  Pose now() const { return Pose::translated(x, y, z); }
};

template <class Traversal, class Question>
Row make_row(const char* algorithm, const typename Traversal::Tree& a,
             const typename Traversal::Tree& b, const Point& translation) {
  return {algorithm, [a, b, translation](std::uint32_t repetitions) {
            const VolatilePose pose = {translation.x, translation.y, translation.z};
            scene::WalkStart<Traversal> start(a, b);
            Counts counts = {0, 0, 0, 0};
            std::uint32_t found = 0;
            for (std::uint32_t i = 0; i < repetitions; ++i) {
              counts = scene::count_query<Traversal, Question>(a, b, pose.now(), start, found);
            }
            return counts;
          }};
}

template <class Question, class Index>
std::vector<Row> rows_of(const BothLayouts<Index>& a, const BothLayouts<Index>& b,
                         const Point& translation) {
  std::vector<Row> rows;
  for_each_traversal([&](auto traversal) {
    constexpr Layout layout = decltype(traversal)::kLayout;
    using Traversal = typename decltype(traversal)::template On<Index, layout>;
    rows.push_back(make_row<Traversal, Question>(traversal.name, a.template in<layout>().view(),
                                                 b.template in<layout>().view(), translation));
  });
  return rows;
}

template <class Question>
std::vector<Row> rows_of(BakedObject& a, BakedObject& b, const Point& translation) {
  return a.fits_16_bits() && b.fits_16_bits()
             ? rows_of<Question>(a.baked<std::uint16_t>(), b.baked<std::uint16_t>(), translation)
             : rows_of<Question>(a.baked<std::uint32_t>(), b.baked<std::uint32_t>(), translation);
}

std::uint32_t scaled_repetitions(std::uint32_t paper, double scale) {
  return static_cast<std::uint32_t>(std::max(1.0, std::round(paper * scale)));
}

/// Of this process alone, as the paper's timer: what else the machine does is left out.
double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const Row& row, std::uint32_t repetitions) {
  const double start = processor_seconds();
  row.run(repetitions);
  return processor_seconds() - start;
}

std::optional<std::uint64_t> best_rule(const scene::Setup& setup, const BakedObject& a,
                                       const BakedObject& b) {
  if (std::max(setup.a.faces(), setup.b.faces()) > kBestRuleFaces) {
    return std::nullopt;
  }
  return best_rule_visits(a.tree(), b.tree(), setup.translation);
}

}  // namespace

std::vector<Row> make_rows(BakedObject& a, BakedObject& b, const Point& translation,
                           Leaves leaves) {
  return leaves == Leaves::boxes ? rows_of<detail::BoxIntersection>(a, b, translation)
                                 : rows_of<detail::Intersection>(a, b, translation);
}

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

const RowResult& SetupResult::row(const std::string& algorithm) const {
  return *std::find_if(rows.begin(), rows.end(), [&](const RowResult& candidate) {
    return candidate.algorithm == algorithm;
  });
}

bool SetupResult::rows_agree() const {
  const auto found = [this](const RowResult& row) {
    return row.counts.visits != 0 && row.counts.triangle_pairs == rows[0].counts.triangle_pairs;
  };
  return std::all_of(shaped.begin(), shaped.end(), found) &&
         std::all_of(rows.begin(), rows.end(), [&](const RowResult& row) {
           return found(row) && row.counts.leaf_pairs == rows[0].counts.leaf_pairs;
         });
}

SetupResult run_setup(const scene::Setup& setup, const Effort& effort, Objects& objects) {
  BakedObject& a = objects.get(setup.a);
  BakedObject& b = objects.get(setup.b);
  SetupResult result = {&setup,
                        scaled_repetitions(setup.repetitions, effort.repetitions_scale),
                        effort.rounds,
                        {},
                        best_rule(setup, a, b),
                        {}};
  std::vector<Row> rows = make_rows(a, b, setup.translation);
  const std::size_t boxes = rows.size();
  std::vector<Row> shapes = make_rows(a, b, setup.translation, Leaves::shapes);
  rows.insert(rows.end(), std::make_move_iterator(shapes.begin()),
              std::make_move_iterator(shapes.end()));
  std::vector<RowResult> results;
  results.reserve(rows.size());
  for (const Row& row : rows) {
    results.push_back({row.algorithm, row.run(1), {}});
  }
  std::vector<std::vector<double>> samples(rows.size());
  for (std::uint32_t round = 0; round < effort.rounds; ++round) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      samples[i].push_back(seconds_of(rows[i], result.repetitions));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    results[i].times = times_of(samples[i]);
  }
  const auto shaped = results.begin() + static_cast<std::ptrdiff_t>(boxes);
  result.shaped.assign(shaped, results.end());
  results.erase(shaped, results.end());
  result.rows = std::move(results);
  return result;
}

namespace {

/// By boxes alone, as the best rule's.
template <template <class> class Order, class Levelled>
Counts visits_of(const Levelled& a, const Levelled& b, const Pose& pose) {
  scene::WalkStart<Order<Levelled>> start(a, b);
  std::uint32_t found = 0;
  return scene::count_query<Order<Levelled>, detail::BoxIntersection>(a, b, pose, start, found);
}

}  // namespace

DefaultTreeResult compare_default_tree(const scene::Setup& setup, Objects& objects) {
  BakedObject& a = objects.get(setup.a);
  BakedObject& b = objects.get(setup.b);
  const Point& t = setup.translation;
  const Pose pose = Pose::translated(t.x, t.y, t.z);
  const Counts stackless = visits_of<AlternatingStackless>(
      a.baked<std::uint32_t>().pre.view(), b.baked<std::uint32_t>().pre.view(), pose);
  const Counts ranked = visits_of<Ranked>(a.baked_default().view(), b.baked_default().view(), pose);
  return {&setup,
          stackless.triangle_pairs != 0,
          {stackless.visits, ranked.visits,
           best_rule_visits(a.default_tree(), b.default_tree(), setup.translation)}};
}

DefaultTreeVisits sum_of(const std::vector<DefaultTreeResult>& results, bool only_intersecting) {
  DefaultTreeVisits sum;
  for (const DefaultTreeResult& result : results) {
    if (result.intersecting || !only_intersecting) {
      sum.stackless += result.visits.stackless;
      sum.ranked += result.visits.ranked;
      sum.best_rule += result.visits.best_rule;
    }
  }
  return sum;
}

}  // namespace flashbvh::tool
