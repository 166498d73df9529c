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

/// UserError if the mesh or its tree exceeds 16-bit indices.
void check_16_bits(const InputMesh& input, const bake::LatticeMesh& mesh,
                   const bake::BuildTree& tree, const TriangleIds& kept, bool offers_wide) {
  const auto check = [&](std::size_t count, const char* what, std::size_t limit, const char* fix) {
    if (count > limit) {
      throw UserError(input.path, count, " ", what, ", but 16-bit indices reach ", limit, "; use ",
                      fix);
    }
  };
  const char* const fewer = offers_wide ? "--simplify, or --index-bits 32" : "--simplify";
  const char* const larger = offers_wide ? "a larger --leaf-size, --simplify, or --index-bits 32"
                                         : "a larger --leaf-size or --simplify";
  check(mesh.triangles.size(), "triangles", kMost16, fewer);
  check(mesh.vertices.size(), "vertices", kMost16, fewer);
  check(tree.nodes.size(), "nodes", kMost16, larger);
  const auto leaves = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                    [](const bake::BuildNode& node) { return node.is_leaf(); });
  check(static_cast<std::size_t>(leaves), "leaves", bake::IndexLimits<std::uint16_t>::kMostLeaves,
        larger);
  if (kept.back() > kMost16) {
    throw UserError(input.path, "triangle ", kept.back(), " is kept, but 16-bit indices reach ",
                    kMost16, "; use --index-bits 32");
  }
}

/// About a 500th of the mesh, to one digit: hardly visible, and makes a large mesh small.
double offered_length(const InputMesh& input) {
  const double length = input.finest_cell * 128;
  const double power = std::pow(10, std::floor(std::log10(length)));
  return std::floor(length / power) * power;
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
  bake::BuildTree tree = options.builder == Builder::median
                             ? bake::build_median(lattice, options.leaf_size)
                             : bake::build_sah(lattice, options.leaf_size);
  tree = bake::collapse(tree, options.arity);
  const bool narrow = options.index_width == IndexWidth::bits_16;
  if (narrow) {
    check_16_bits(input, lattice, tree, rounded.kept, options.offers_wide_indices);
  }
  AnyBakedTree baked = narrow ? lay_out<std::uint16_t>(tree, lattice, options.layout)
                              : lay_out<std::uint32_t>(tree, lattice, options.layout);
  std::visit([&](auto& any) { renumber(any, rounded.kept); }, baked);
  return baked;
}

std::string offer_of(const InputMesh& input, const BakeOptions& options, double length) {
  const double cell = options.cell.value_or(input.finest_cell);
  simplify::Coarsening coarsening(input.mesh, cell);
  coarsening.coarsen(std::max(length, coarsening.rounding()));
  BakeOptions own = options;
  own.cell = cell;
  const double bytes = coarse_bytes(input, coarsening, own, "");
  if (!std::isfinite(bytes)) {
    return concat("not even --simplify ", shortest(length), " makes it fit: cut it in parts");
  }
  return concat("with --simplify ", shortest(length), " ", coarsening.triangle_count(),
                " of them are left, in ", fixed(bytes, 0), " bytes");
}

BakedMesh bake(const InputMesh& input, const BakeOptions& options) {
  RoundedMesh rounded = round_mesh(input, options);
  const std::size_t count = rounded.lattice.triangles.size();
  if (options.index_width == IndexWidth::bits_16 && count > kMost16) {
    throw UserError(input.path, count, " triangles, but 16-bit indices reach ", kMost16, "; ",
                    offer_of(input, options, offered_length(input)),
                    options.offers_wide_indices ? "; or use --index-bits 32" : "");
  }
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
