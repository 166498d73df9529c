// Finds the least coarsening that fits flash.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "simplify/coarsening.hpp"

namespace flashbvh::simplify {

/// The size of all meshes in flash in their current coarseness, in leaves of `leaf_size` triangles.
/// Infinite if they can't be baked.
using BytesOf = std::function<double(const std::vector<Coarsening>&, std::uint32_t leaf_size)>;

/// The longest useful length, as a part of the largest mesh's longest side: more distorts the
/// shape.
constexpr double kLongestPart = 1.0 / 20;

struct Fit {
  double length = 0;  ///< 0: no mesh was coarsened
  std::uint32_t leaf_size = 0;
};

/// Coarsens all meshes, on all processors.
void coarsen_all(std::vector<Coarsening>& meshes, double length,
                 const tool::Deadline& deadline = {});

/// An estimate of the length with which original meshes fit; 0: unchanged. May be wrong.
double likely_length(const std::vector<Coarsening>& meshes, double most, double longest,
                     const tool::Deadline& deadline = {});

/// Coarsens original meshes until they take `most` bytes, with the least length but for a tenth. Of
/// `leaf_sizes`, ascending, takes the first one that costs no more than kWorthwhile times the least
/// length of any. None if they do not fit with `longest`, or if the deadline passes before they do.
std::optional<Fit> fit(std::vector<Coarsening>& meshes, double most, double longest,
                       const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of,
                       const tool::Deadline& deadline = {});

}  // namespace flashbvh::simplify
