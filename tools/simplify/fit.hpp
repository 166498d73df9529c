// As little coarser as it takes to fit flash; what each length costs.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "simplify/coarsening.hpp"

namespace flashbvh::simplify {

/// What all meshes take in flash as coarse as they are, in leaves of so many triangles. Infinite if
/// they can't be baked.
using BytesOf = std::function<double(const std::vector<Coarsening>&, std::uint32_t leaf_size)>;

struct Fit {
  double length = 0;  ///< 0: nothing had to become coarser
  std::uint32_t leaf_size = 0;
};

/// Makes all coarser, on all processors.
void coarsen_all(std::vector<Coarsening>& meshes, double length);

/// About the length with which meshes that are not coarsened yet fit; no promise. 0: as they are.
double likely_length(const std::vector<Coarsening>& meshes, double most, double longest);

/// Makes meshes that are not coarsened yet coarser until they take `most` bytes, with the least
/// length of a ladder of kStep. Of `leaf_sizes`, ascending, the first one that costs no more than
/// kWorthwhile times the least length of any. None if they do not fit with `longest`.
std::optional<Fit> fit(std::vector<Coarsening>& meshes, double most, double longest,
                       const std::vector<std::uint32_t>& leaf_sizes, const BytesOf& bytes_of);

/// What a length costs.
struct LengthRow {
  double length;
  std::size_t triangles;
  std::vector<double> bytes;  ///< of each leaf size
};

/// Of 0 and then of 1, 2 and 5 times powers of ten up to `longest`, as far down as they make sense
/// for the meshes. Makes the meshes coarser.
std::vector<LengthRow> length_table(std::vector<Coarsening>& meshes, double longest,
                                    const std::vector<std::uint32_t>& leaf_sizes,
                                    const BytesOf& bytes_of);

}  // namespace flashbvh::simplify
