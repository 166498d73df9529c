#include "comparison.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>

namespace compare {
namespace {

/// Samples per library; the result is their median.
constexpr std::size_t kRounds = 25;
/// The shortest sample of the fastest library. All libraries make the same number of walks over the
/// poses, so none starts with a warmer branch predictor. It is 1 unless queries are short.
constexpr double kSampleNanoseconds = 10e3;

/// Nanoseconds per query, averaged over the poses.
double sample(Competitor& library, Wanted wanted, int walks) {
  static volatile std::size_t found;  // keeps the compiler from removing queries
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < walks; ++i) {
    found = library.query_all(wanted);
  }
  const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - began;
  return passed.count() / (walks * static_cast<double>(kPoses));
}

double median(std::vector<double>& samples) {
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

/// Medians of the samples per library. Every round runs all libraries, so slowdowns affect all, and
/// in a new order, because each library leaves caches and predictors to the next.
std::vector<double> time_all(const std::vector<Timed>& libraries, Wanted wanted,
                             flashbvh::test::Random& random) {
  double fastest = 1e9;
  for (const Timed& timed : libraries) {
    fastest = std::min(fastest, sample(*timed.library, wanted, 1));
  }
  const int walks = 1 + static_cast<int>(kSampleNanoseconds / (fastest * kPoses));
  std::vector<std::vector<double>> samples(libraries.size());
  std::vector<std::size_t> order(libraries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    }
    for (const std::size_t i : order) {
      samples[i].push_back(sample(*libraries[i].library, wanted, walks));
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& of_one : samples) {
    medians.push_back(median(of_one));
  }
  return medians;
}

}  // namespace

void print_times(const std::vector<Timed>& libraries, Wanted wanted, const std::string& of,
                 flashbvh::test::Random& random) {
  const std::vector<double> times = time_all(libraries, wanted, random);
  for (std::size_t i = 0; i < libraries.size(); ++i) {
    std::printf("time %s %s %.2f\n", of.c_str(), libraries[i].name, times[i]);
  }
}

}  // namespace compare
