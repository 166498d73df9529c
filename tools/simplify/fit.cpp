#include "simplify/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "text/parallel.hpp"

namespace flashbvh::simplify {
namespace {

/// The ratio of successive lengths.
constexpr double kStep = 1.1;
/// Smaller leaves, which answer faster, are worth a length up to this much longer.
constexpr double kWorthwhile = 1.25;
/// Smaller leaves are not tried if the meshes would have to shrink by more.
constexpr double kTooLarge = 1.15;
/// Of a triangle in large leaves: to guess the length that fits.
constexpr double kBytesOfTriangle = 17;
/// The part of the guess to begin at: a start that is too coarse restarts with all triangles.
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

  /// The first leaf size with which the meshes fit, or 0.
  std::uint32_t leaf_size(const std::vector<Coarsening>& coarse) const {
    for (const std::uint32_t size : leaf_sizes) {
      if (bytes_of(coarse, size) <= most) {
        return size;
      }
    }
    return 0;
  }

  std::optional<Fit> made() const {
    if (const std::uint32_t size = leaf_size(meshes)) {
      return Fit{0, size};
    }
    const std::optional<Fit> found = climbed(begun());
    return found && found->leaf_size > leaf_sizes.front() ? with_smaller_leaves(*found) : found;
  }

  /// Coarsens the meshes, but not so far that they fit unless the length is the shortest. Returns
  /// the length.
  double begun() const {
    const double shortest = kAboveRounding * most_rounding(meshes);
    const std::vector<Coarsening> full = meshes;
    double length = likely_length(meshes, most, longest);
    do {
      length = std::min(rounded_up(std::max(kBegin * length, shortest)), longest);
      meshes = full;
      coarsen_all(meshes, length);
    } while (length > shortest * kStep && leaf_size(meshes) != 0);
    return length;
  }

  /// Coarsens by two steps at a time, then tries one step less.
  std::optional<Fit> climbed(double length) const {
    std::uint32_t size = leaf_size(meshes);
    std::vector<Coarsening> before = meshes;
    while (size == 0) {
      if (length >= longest) {
        return std::nullopt;
      }
      before = meshes;
      const double step = std::min(rounded_up(length * kStep), longest);
      const double next = std::min(rounded_up(step * kStep), longest);
      coarsen_all(meshes, next);
      size = leaf_size(meshes);
      if (size != 0) {
        coarsen_all(before, step);
        if (const std::uint32_t own = leaf_size(before)) {
          meshes = std::move(before);
          return Fit{step, own};
        }
      }
      length = next;
    }
    return Fit{length, size};
  }

  Fit with_smaller_leaves(const Fit& found) const {
    const auto last = std::find(leaf_sizes.begin(), leaf_sizes.end(), found.leaf_size);
    if (bytes_of(meshes, *(last - 1)) > kTooLarge * most) {
      return found;
    }
    std::vector<Coarsening> longer = meshes;
    for (double next = found.length * kStep; next <= std::min(kWorthwhile * found.length, longest);
         next *= kStep) {
      coarsen_all(longer, rounded_up(next));
      const std::uint32_t smaller = leaf_size(longer);
      if (smaller != 0 && smaller < found.leaf_size) {
        meshes = std::move(longer);
        return Fit{rounded_up(next), smaller};
      }
    }
    return found;
  }
};

}  // namespace

void coarsen_all(std::vector<Coarsening>& meshes, double length) {
  tool::for_each_in_parallel(meshes.size(), [&](std::size_t i) {
    meshes[i].coarsen(std::max(length, meshes[i].rounding()));
  });
}

double likely_length(const std::vector<Coarsening>& meshes, double most, double longest) {
  const auto fits = [&](std::size_t triangles) {
    return static_cast<double>(triangles) * kBytesOfTriangle <= most;
  };
  if (fits(triangles_of(meshes))) {
    return 0;
  }
  double low = std::min(kAboveRounding * most_rounding(meshes), longest);
  double high = longest;
  while (high > low * kStep) {
    const double middle = std::sqrt(low * high);
    (fits(estimate(meshes, middle)) ? high : low) = middle;
  }
  return high;
}

std::optional<Fit> fit(std::vector<Coarsening>& meshes, double most, double longest,
                       const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of) {
  return Fitting{meshes, most, longest, leaf_sizes, bytes_of}.made();
}

}  // namespace flashbvh::simplify
