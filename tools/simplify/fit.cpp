#include "simplify/fit.hpp"

#include <algorithm>
#include <cmath>

#include "text/parallel.hpp"

namespace flashbvh::simplify {
namespace {

/// From one length to the next.
constexpr double kStep = 1.1;
/// So much longer a length is worth smaller leaves, which answer faster.
constexpr double kWorthwhile = 1.25;
/// Where to begin is guessed by so many bytes a triangle.
constexpr double kBytesOfTriangle = 17;
/// Shorter lengths than this multiple of the rounding leave a mesh as it is.
constexpr double kAboveRounding = 1.5;
constexpr std::size_t kMostRows = 6;

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
  std::size_t sum = 0;
  for (const std::size_t count : counts) {
    sum += count;
  }
  return sum;
}

/// A length with which they about fit.
double guess(const std::vector<Coarsening>& meshes, double most, double shortest, double longest) {
  double low = shortest;
  double high = longest;
  while (high > low * kStep * kStep) {
    const double middle = std::sqrt(low * high);
    const bool fits = static_cast<double>(estimate(meshes, middle)) * kBytesOfTriangle <= most;
    (fits ? high : low) = middle;
  }
  return low;
}

/// To three digits, upwards.
double rounded_up(double length) {
  const int power = static_cast<int>(std::floor(std::log10(length))) - 2;
  const double unit = std::pow(10, std::abs(power));
  return power < 0 ? std::ceil(length * unit) / unit : std::ceil(length / unit) * unit;
}

/// The first leaf size with which they fit, or 0.
std::uint32_t fitting(const std::vector<Coarsening>& meshes, double most,
                      const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of) {
  for (const std::uint32_t leaf_size : leaf_sizes) {
    if (bytes_of(meshes, leaf_size) <= most) {
      return leaf_size;
    }
  }
  return 0;
}

}  // namespace

void coarsen_all(std::vector<Coarsening>& meshes, double length) {
  tool::for_each_in_parallel(meshes.size(), [&](std::size_t i) {
    meshes[i].coarsen(std::max(length, meshes[i].rounding()));
  });
}

std::optional<Fit> fit(std::vector<Coarsening>& meshes, double most, double longest,
                       const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of) {
  if (const std::uint32_t leaf_size = fitting(meshes, most, leaf_sizes, bytes_of)) {
    return Fit{0, leaf_size};
  }
  const double shortest = kAboveRounding * most_rounding(meshes);
  const std::vector<Coarsening> full = meshes;
  double length = rounded_up(guess(meshes, most, shortest, longest));
  coarsen_all(meshes, length);
  while (fitting(meshes, most, leaf_sizes, bytes_of) != 0 && length > shortest * kStep) {
    length = rounded_up(std::max(length / (kStep * kStep * kStep), shortest));
    meshes = full;
    coarsen_all(meshes, length);
  }
  return fit_from(length, meshes, most, longest, leaf_sizes, bytes_of);
}

std::optional<Fit> fit_from(double length, std::vector<Coarsening>& meshes, double most,
                            double longest, const std::vector<std::uint32_t>& leaf_sizes,
                            const BytesOf& bytes_of) {
  std::uint32_t leaf_size = fitting(meshes, most, leaf_sizes, bytes_of);
  while (leaf_size == 0) {
    if (length >= longest) {
      return std::nullopt;
    }
    length = std::min(rounded_up(length * kStep), longest);
    coarsen_all(meshes, length);
    leaf_size = fitting(meshes, most, leaf_sizes, bytes_of);
  }
  std::vector<Coarsening> longer = meshes;
  for (double next = length * kStep; leaf_size > leaf_sizes.front() && next <= kWorthwhile * length;
       next *= kStep) {
    coarsen_all(longer, rounded_up(next));
    const std::uint32_t smaller = fitting(longer, most, leaf_sizes, bytes_of);
    if (smaller < leaf_size) {
      meshes = std::move(longer);
      return Fit{rounded_up(next), smaller};
    }
  }
  return Fit{length, leaf_size};
}

std::vector<LengthRow> length_table(std::vector<Coarsening>& meshes, double longest,
                                    const std::vector<std::uint32_t>& leaf_sizes,
                                    const BytesOf& bytes_of) {
  std::vector<LengthRow> rows;
  const auto add = [&](double length) {
    LengthRow row = {length, triangles_of(meshes), {}};
    for (const std::uint32_t leaf_size : leaf_sizes) {
      row.bytes.push_back(bytes_of(meshes, leaf_size));
    }
    rows.push_back(std::move(row));
  };
  add(0);
  std::vector<double> lengths;
  constexpr std::array<double, 3> kDigits = {5, 2, 1};
  for (int power = static_cast<int>(std::floor(std::log10(longest))); lengths.size() < kMostRows;
       --power) {
    for (const double digit : kDigits) {
      const double length = power < 0 ? digit / std::pow(10, -power) : digit * std::pow(10, power);
      if (length <= longest && lengths.size() < kMostRows) {
        lengths.push_back(length);
      }
    }
  }
  const double shortest = kAboveRounding * most_rounding(meshes);
  for (auto length = lengths.rbegin(); length != lengths.rend(); ++length) {
    if (*length > shortest) {
      coarsen_all(meshes, *length);
      add(*length);
    }
  }
  return rows;
}

}  // namespace flashbvh::simplify
