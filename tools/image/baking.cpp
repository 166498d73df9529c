#include "image/baking.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bake/build_tree.hpp"
#include "bake/image_bytes.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::size_t kMost16 = bake::IndexLimits<std::uint16_t>::kMost;

/// UserError if 16-bit indices do not reach so many. `fix` comes before others.
void check_16_bits(const InputMesh& input, std::size_t count, const char* what, std::size_t most,
                   const char* fix = "") {
  if (count > most) {
    throw UserError(input.path, count, " ", what, ", but 16-bit indices reach ", most, "; use ",
                    fix, "--simplify, or --index-bits 32 of `flashbvh bake`");
  }
}

void check_tree(const InputMesh& input, const bake::BuildTree& tree) {
  constexpr const char* kFix = "a larger --leaf-size, ";
  check_16_bits(input, tree.nodes.size(), "nodes", kMost16, kFix);
  const auto leaves = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                    [](const bake::BuildNode& node) { return node.is_leaf(); });
  check_16_bits(input, static_cast<std::size_t>(leaves), "leaves",
                bake::IndexLimits<std::uint16_t>::kMostLeaves, kFix);
}

/// Gives the triangles their numbers in the file.
template <class Index, Layout layout>
void renumber(bake::BakedTree<Index, layout>& baked, const TriangleIds& kept) {
  for (Index& source : baked.triangle_ids) {
    source = static_cast<Index>(kept[source]);
  }
}

template <class Index>
AnyBakedTree lay_out(const bake::BuildTree& tree, const bake::LatticeMesh& mesh, Layout layout) {
  if (layout == Layout::pre_indexed) {
    return bake::lay_out<Index, Layout::pre_indexed>(tree, mesh);
  }
  return bake::lay_out<Index, Layout::post_indexed>(tree, mesh);
}

BakeOptions without_limit(BakeOptions options) {
  options.max_deviation = std::nullopt;
  return options;
}

}  // namespace

AnyBakedTree build_tree(const InputMesh& input, const RoundedMesh& rounded,
                        const BakeOptions& options) {
  const bake::LatticeMesh& lattice = rounded.lattice;
  const bool narrow = options.index_width == IndexWidth::bits_16;
  if (narrow) {
    check_16_bits(input, lattice.triangles.size(), "triangles", kMost16);
    check_16_bits(input, lattice.vertices.size(), "vertices", kMost16);
    check_16_bits(input, rounded.kept.back(), "is the number of a triangle", kMost16);
  }
  const bake::BuildTree tree = bake::collapse(options.builder == Builder::median
                                                  ? bake::build_median(lattice, options.leaf_size)
                                                  : bake::build_sah(lattice, options.leaf_size),
                                              options.arity);
  if (narrow) {
    check_tree(input, tree);
  }
  AnyBakedTree baked = narrow ? lay_out<std::uint16_t>(tree, lattice, options.layout)
                              : lay_out<std::uint32_t>(tree, lattice, options.layout);
  std::visit([&](auto& any) { renumber(any, rounded.kept); }, baked);
  return baked;
}

BakedMesh bake(const InputMesh& input, const BakeOptions& options) {
  RoundedMesh rounded = round_mesh(input, options);
  return {build_tree(input, rounded, options), std::move(rounded.defects), rounded.dropped};
}

double coarse_bytes(const InputMesh& input, const simplify::Coarsening& coarse,
                    const BakeOptions& options, const std::string& name, bool levels) {
  const InputMesh made = coarse.is_original() ? input : input_of(input.path, coarse.mesh());
  const BakeOptions own = without_limit(options);
  try {
    AnyBakedTree tree = build_tree(made, round_mesh(made, own), own);
    return std::visit(
        [&](auto& baked) {
          baked.name = name.substr(0, bake::kMaxNameSize);
          return static_cast<double>(bake::image_size(baked, levels));
        },
        tree);
  } catch (const UserError&) {
    return HUGE_VAL;
  }
}

BakedMesh bake(const InputMesh& input, const BakeOptions& options,
               const simplify::Coarsening& coarse) {
  MeshDefects defects = defects_of(input.mesh, coarse.rounded(), input.degenerate);
  const InputMesh made = input_of(input.path, coarse.mesh());
  RoundedMesh rounded = round_mesh(made, without_limit(options));
  rounded.lattice.deviation = coarse.deviation().most + input.reading_error() + rounded.dropped;
  if (!std::isfinite(rounded.lattice.deviation)) {
    throw UserError(input.path,
                    "the simplified mesh's deviation can't be certified; simplify to "
                    "another length");
  }
  if (options.max_deviation && rounded.lattice.deviation > *options.max_deviation) {
    throw UserError(input.path, "the simplified mesh deviates by ",
                    text_of(rounded.lattice.deviation, options), ", --max-deviation allows ",
                    text_of(*options.max_deviation, options));
  }
  return {build_tree(made, rounded, options), std::move(defects), rounded.dropped};
}

}  // namespace flashbvh::tool
