#include "cli/mesh/bake_simplified.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bake/quantise.hpp"
#include "cli/mesh/mesh_warnings.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

double side_of_largest(const std::vector<InputMesh>& meshes) {
  double longest = 0;
  for (const InputMesh& mesh : meshes) {
    longest = std::max(longest, longest_side(size_of(mesh.mesh)));
  }
  return longest;
}

std::vector<simplify::Coarsening> coarsenings(const std::vector<InputMesh>& meshes, double cell) {
  std::vector<simplify::Coarsening> all;
  for (const InputMesh& mesh : meshes) {
    if (!bake::fits(mesh.mesh, cell)) {
      return {};  // bake() reports the error
    }
    all.emplace_back(mesh.mesh, cell);
  }
  return all;
}

simplify::BytesOf bytes_of(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                           const std::vector<std::string>& names, const BakeOptions& options) {
  return [&order, &meshes, &names, options](const std::vector<simplify::Coarsening>& coarse,
                                            std::uint32_t leaf_size) {
    BakeOptions own = options;
    own.leaf_size = leaf_size;
    std::vector<double> bytes(coarse.size());
    for_each_in_parallel(coarse.size(), [&](std::size_t i) {
      bytes[i] = coarse_bytes(meshes[i], coarse[i], own, names[i], order.levels);
    });
    return std::accumulate(bytes.begin(), bytes.end(), 0.0);
  };
}

Simplified simplified_to(double length, const std::vector<InputMesh>& meshes, double cell) {
  Simplified made{coarsenings(meshes, cell), length};
  for (std::size_t i = 0; i < made.meshes.size(); ++i) {
    if (length < made.meshes[i].rounding()) {
      throw UserError("--simplify " + shortest(length), "is less than rounding moves a vertex of ",
                      meshes[i].path, ", ", shortest(made.meshes[i].rounding()),
                      "; give that or more, or a finer --cell");
    }
  }
  simplify::coarsen_all(made.meshes, length);
  return made;
}

}  // namespace

Simplified simplified_meshes(const BakeOrder& order, const std::vector<InputMesh>& meshes,
                             const std::vector<std::string>& names, BakeOptions& options) {
  if (order.simplify) {
    return simplified_to(*order.simplify, meshes, *options.cell);
  }
  if (!order.fit) {
    return {};
  }
  Simplified made{coarsenings(meshes, *options.cell), 0};
  const double longest = std::min(simplify::kLongestPart * side_of_largest(meshes),
                                  options.max_deviation.value_or(HUGE_VAL));
  const auto found = simplify::fit(made.meshes, static_cast<double>(*order.fit), longest,
                                   order.leaf_sizes, bytes_of(order, meshes, names, options));
  if (!found) {
    throw UserError(
        concat("--fit ", *order.fit), "is not reached by simplifying to ", significant(longest, 3),
        options.max_deviation ? ", --max-deviation" : ", a twentieth of the largest mesh",
        "; give more bytes",
        options.max_deviation ? " or a larger --max-deviation" : " or bake fewer meshes");
  }
  options.leaf_size = found->leaf_size;
  made.length = found->length;
  if (made.length == 0) {
    made.meshes.clear();
  }
  return made;
}

std::vector<simplify::LengthRow> lengths_of(const BakeOrder& order,
                                            const std::vector<InputMesh>& meshes,
                                            const std::vector<std::string>& names,
                                            const BakeOptions& options) {
  const double longest = simplify::kLongestPart * side_of_largest(meshes);
  std::vector<simplify::Coarsening> all = coarsenings(meshes, *options.cell);
  return longest > 0 && !all.empty()
             ? simplify::length_table(all, longest, order.leaf_sizes,
                                      bytes_of(order, meshes, names, options))
             : std::vector<simplify::LengthRow>();
}

}  // namespace flashbvh::tool
