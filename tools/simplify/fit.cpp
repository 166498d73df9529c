#include "simplify/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "text/parallel.hpp"

namespace flashbvh::simplify {
namespace {

/// The least ratio of two lengths that are tried.
constexpr double kStep = 1.1;
/// Smaller leaves, which answer faster, are worth a length up to this much longer.
constexpr double kWorthwhile = 1.25;
/// Smaller leaves are not tried if the meshes would have to shrink by more.
constexpr double kTooLarge = 1.15;
/// Of a triangle in large leaves: to guess the length that fits.
constexpr double kBytesOfTriangle = 17;
/// The part of the guess to begin at: a length that is too long begins again with all triangles.
constexpr double kBegin = 0.6;
/// Lengths below this multiple of the rounding leave a mesh unchanged.
constexpr double kAboveRounding = 1.5;

double most_rounding(const std::vector<Coarsening>& meshes) {
  double most = 0;
  for (const Coarsening& mesh : meshes) {
    most = std::max(most, mesh.rounding());
  }
  return most;
}

std::size_t triangles_of(const std::vector<Coarsening>& meshes) {
  std::size_t count = 0;
  for (const Coarsening& mesh : meshes) {
    count += mesh.triangle_count();
  }
  return count;
}

std::size_t estimate(const std::vector<Coarsening>& meshes, double length) {
  std::vector<std::size_t> counts(meshes.size());
  tool::for_each_in_parallel(meshes.size(),
                             [&](std::size_t i) { counts[i] = meshes[i].estimate(length); });
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// Rounds up to three digits.
double rounded_up(double length) {
  const int power = static_cast<int>(std::floor(std::log10(length))) - 2;
  const double unit = std::pow(10, std::abs(power));
  return power < 0 ? std::ceil(length * unit) / unit : std::ceil(length / unit) * unit;
}

/// A call of fit().
struct Fitting {
  std::vector<Coarsening>& meshes;
  double most;
  double longest;
  const std::vector<std::uint32_t>& leaf_sizes;
  const BytesOf& bytes_of;
  const tool::Deadline& deadline;

  /// The first leaf size with which the meshes fit.
  std::optional<std::uint32_t> leaf_size(const std::vector<Coarsening>& coarse) const {
    for (const std::uint32_t size : leaf_sizes) {
      if (bytes_of(coarse, size) <= most) {
        return size;
      }
    }
    return std::nullopt;
  }

  std::optional<Fit> made() const {
    if (const auto size = leaf_size(meshes)) {
      return Fit{0, *size};
    }
    const std::optional<Fit> found = bisected();
    return found && found->leaf_size > leaf_sizes.front() ? with_smaller_leaves(*found) : found;
  }

  /// Finds two lengths, a step apart at most, with the longer of which alone the meshes fit.
  std::optional<Fit> bisected() const {
    const double shortest = std::min(kAboveRounding * most_rounding(meshes), longest);
    std::vector<Coarsening> below = meshes;  // do not fit
    double low = 0;                          // their length
    std::optional<Fit> found;
    double next = kBegin * likely_length(meshes, most, longest, deadline);
    while (!deadline.is_past() && (!found || found->length > std::max(low, shortest) * kStep)) {
      next = std::min(rounded_up(std::max(next, shortest)), longest);
      std::vector<Coarsening> coarse = below;
      coarsen_all(coarse, next, deadline);
      if (const auto size = leaf_size(coarse)) {
        found = Fit{next, *size};
        meshes = std::move(coarse);
      } else if (next >= longest) {
        return std::nullopt;
      } else {
        low = next;
        below = std::move(coarse);
      }
      next = !found     ? low * kStep * kStep
             : low == 0 ? kBegin * found->length
                        : std::sqrt(low * found->length);
    }
    return found;
  }

  Fit with_smaller_leaves(const Fit& found) const {
    const auto last = std::find(leaf_sizes.begin(), leaf_sizes.end(), found.leaf_size);
    if (bytes_of(meshes, *(last - 1)) > kTooLarge * most) {
      return found;
    }
    std::vector<Coarsening> longer = meshes;
    for (double next = found.length * kStep;
         next <= std::min(kWorthwhile * found.length, longest) && !deadline.is_past();
         next *= kStep) {
      coarsen_all(longer, rounded_up(next), deadline);
      const auto smaller = leaf_size(longer);
      if (smaller && *smaller < found.leaf_size) {
        meshes = std::move(longer);
        return Fit{rounded_up(next), *smaller};
      }
    }
    return found;
  }
};

}  // namespace

void coarsen_all(std::vector<Coarsening>& meshes, double length, const tool::Deadline& deadline) {
  tool::for_each_in_parallel(meshes.size(), [&](std::size_t i) {
    meshes[i].coarsen(std::max(length, meshes[i].rounding()), deadline);
  });
}

double likely_length(const std::vector<Coarsening>& meshes, double most, double longest,
                     const tool::Deadline& deadline) {
  const auto fits = [&](std::size_t triangles) {
    return static_cast<double>(triangles) * kBytesOfTriangle <= most;
  };
  if (fits(triangles_of(meshes))) {
    return 0;
  }
  double low = std::min(kAboveRounding * most_rounding(meshes), longest);
  double high = longest;
  while (high > low * kStep && !deadline.is_past()) {
    const double middle = std::sqrt(low * high);
    (fits(estimate(meshes, middle)) ? high : low) = middle;
  }
  return high;
}

std::optional<Fit> fit(std::vector<Coarsening>& meshes, double most, double longest,
                       const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of,
                       const tool::Deadline& deadline) {
  return Fitting{meshes, most, longest, leaf_sizes, bytes_of, deadline}.made();
}

}  // namespace flashbvh::simplify
