#include "cli/mesh/bake_options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "image/mesh_warnings.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

double side_of_largest(const std::vector<InputMesh>& meshes) {
  double longest = 0;
  for (const InputMesh& mesh : meshes) {
    longest = std::max(longest, longest_side(mesh.extent.size()));
  }
  return longest;
}

/// The most by which a reader rounds; it reduces the length left for simplifying.
double reading_error(const std::vector<InputMesh>& meshes) {
  double most = 0;
  for (const InputMesh& mesh : meshes) {
    most = std::max(most, mesh.reading_error());
  }
  return most;
}

std::vector<simplify::Coarsening> coarsenings(const std::vector<InputMesh>& meshes,
                                              const BakeOptions& options) {
  std::vector<simplify::Coarsening> all;
  all.reserve(meshes.size());
  for (const InputMesh& mesh : meshes) {
    all.emplace_back(mesh.mesh, lattice_of(mesh, options));
  }
  return all;
}

simplify::BytesOf bytes_of(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                           const BakeOptions& options) {
  return [&order, &meshes, options](const std::vector<simplify::Coarsening>& coarse,
                                    std::uint32_t leaf_size) {
    BakeOptions own = options;
    own.leaf_size = leaf_size;
    std::vector<double> bytes(coarse.size());
    for_each_in_parallel(coarse.size(), [&](std::size_t i) {
      bytes[i] = coarse_bytes(meshes[i], coarse[i], own, order.names[i].stem, order.levels);
    });
    return std::accumulate(bytes.begin(), bytes.end(), 0.0);
  };
}

Simplified simplified_to(double length, const std::vector<InputMesh>& meshes,
                         const BakeOptions& options) {
  Simplified made{coarsenings(meshes, options), length};
  for (std::size_t i = 0; i < made.meshes.size(); ++i) {
    const double least = made.meshes[i].rounding() + meshes[i].reading_error();
    if (length < least) {
      throw UserError("--simplify " + shortest(length), "is less than rounding moves a vertex of ",
                      meshes[i].path, ", ", shortest(least),
                      "; give that or more, or a finer --cell");
    }
  }
  simplify::coarsen_all(made.meshes, length - reading_error(meshes));
  return made;
}

}  // namespace

Simplified simplified_meshes(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                             BakeOptions& options) {
  if (order.simplify) {
    return simplified_to(*order.simplify, meshes, options);
  }
  if (!order.fit) {
    return {};
  }
  Simplified made{coarsenings(meshes, options), 0};
  const double twentieth = simplify::kLongestPart * side_of_largest(meshes);
  const double allowed = options.max_deviation
                             ? std::max(*options.max_deviation - reading_error(meshes), 0.0)
                             : HUGE_VAL;
  const bool is_limited = allowed < twentieth;
  const double longest = is_limited ? allowed : twentieth;
  const auto found = simplify::fit(made.meshes, *order.fit, longest, order.leaf_sizes,
                                   bytes_of(order, meshes, options));
  if (!found) {
    throw UserError("--fit " + fixed(*order.fit, 0), "is not reached by simplifying to ",
                    significant(is_limited ? *options.max_deviation : twentieth, 3),
                    is_limited ? ", --max-deviation" : ", a twentieth of the largest mesh",
                    "; give more bytes",
                    is_limited ? " or a larger --max-deviation" : " or bake fewer meshes");
  }
  options.leaf_size = found->leaf_size;
  if (found->length == 0) {
    made.meshes.clear();
  } else {
    made.length = found->length + reading_error(meshes);
  }
  return made;
}

}  // namespace flashbvh::tool
