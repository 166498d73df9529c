#include "image/baking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "bake/build_tree.hpp"
#include "bake/image_bytes.hpp"
#include "bake/quantise.hpp"
#include "simplify/deviation.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest cell that moves no vertex further than `deviation`, half the diagonal of a cell, but
/// for the rounding of doubles.
double sure_cell(double deviation) {
  return deviation * 2 / std::sqrt(3.0) * (1 - 0x1p-48);
}

/// A length for messages.
std::string text_of(double length, const BakeOptions& options) {
  return shortest(length) + (options.unit.empty() ? "" : " " + options.unit);
}

void check_range(const InputMesh& input, double cell, const BakeOptions& options) {
  if (bake::fits(input.mesh, cell)) {
    return;
  }
  throw UserError(input.path, "is too large for a cell of ", text_of(cell, options),
                  ": out of range are ", triangle_list(bake::out_of_range(input.mesh, cell)),
                  "; the finest that it fits is --cell ", shortest(finest_cell(input)));
}

void check_deviation(const InputMesh& input, const bake::LatticeMesh& rounded,
                     const BakeOptions& options, double dropped) {
  const std::optional<double>& most = options.max_deviation;
  if (!most || rounded.deviation <= *most) {
    return;
  }
  if (dropped > 0) {
    throw UserError(input.path, "triangles to drop lie up to ", text_of(dropped, options),
                    " from all others, --max-deviation allows ", text_of(*most, options),
                    "; leave --drop out, or repair the mesh");
  }
  const double cell = sure_cell(*most - input.reading_error());
  throw UserError(input.path, "rounding moves a vertex by ", text_of(rounded.deviation, options),
                  ", --max-deviation allows ", text_of(*most, options),
                  cell >= finest_cell(input)
                      ? "; a cell of " + text_of(cell, options) + " or less keeps to that"
                      : "; the mesh is too large for so fine a cell: cut it in parts");
}

/// Triangles by their vertices, and their edges and corners, as edges without length.
class Covered {
 public:
  void add(const bake::TriangleCorners& corners) {
    triangles_.insert(sorted(corners));
    for (const std::uint32_t from : corners) {
      for (const std::uint32_t to : corners) {
        edges_.insert({from, to});
      }
    }
  }

  bool has(const bake::TriangleCorners& corners) const {
    return triangles_.count(sorted(corners)) != 0;
  }
  /// True for a triangle without area if two of its edges are there: they contain the third.
  bool has_line(const bake::TriangleCorners& corners) const {
    const auto& [p, q, r] = corners;
    return edges_.count({p, q}) + edges_.count({q, r}) + edges_.count({r, p}) >= 2;
  }

 private:
  static bake::TriangleCorners sorted(bake::TriangleCorners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  std::set<bake::TriangleCorners> triangles_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges_;
};

/// These triangles, in cells.
bake::SourceMesh in_cells(const bake::LatticeMesh& mesh, const TriangleIds& numbers) {
  const bake::LatticeMesh part = part_of(mesh, numbers);
  bake::SourceMesh made;
  for (const Vertex& v : part.vertices) {
    made.vertices.push_back({1.0 * v.x, 1.0 * v.y, 1.0 * v.z});
  }
  made.triangles = part.triangles;
  return made;
}

/// RoundedMesh::dropped. A triangle without area in the file is a line there, once rounded too.
double dropped_distance(const bake::LatticeMesh& mesh, const MeshDefects& defects,
                        const TriangleIds& kept, const TriangleIds& dropped) {
  Covered covered;
  for (const std::uint32_t triangle : kept) {
    covered.add(mesh.triangles[triangle]);
  }
  TriangleIds apart;
  for (const std::uint32_t triangle : dropped) {
    const bake::TriangleCorners& corners = mesh.triangles[triangle];
    const auto is_in = [&](const TriangleIds& ids) {
      return std::binary_search(ids.begin(), ids.end(), triangle);
    };
    const bool is_line = is_in(defects.degenerate) || is_in(defects.collapsed);
    if (!covered.has(corners) && !(is_line && covered.has_line(corners))) {
      apart.push_back(triangle);
    }
  }
  return apart.empty()
             ? 0
             : simplify::farthest_from(in_cells(mesh, kept), in_cells(mesh, apart)) * mesh.cell;
}

/// Removes triangles as the options say, and unused vertices.
void drop(RoundedMesh& rounded, const InputMesh& input, const BakeOptions& options) {
  bake::LatticeMesh& mesh = rounded.lattice;
  const MeshDefects& defects = rounded.defects;
  std::vector<bool> dropped(mesh.triangles.size(), false);
  const auto mark = [&](const TriangleIds& triangles, bool wanted) {
    for (const std::uint32_t triangle : triangles) {
      dropped[triangle] = dropped[triangle] || wanted;
    }
  };
  mark(defects.degenerate, options.drop_degenerate);
  mark(defects.collapsed, options.drop_degenerate);
  mark(defects.duplicates, options.drop_duplicate);
  TriangleIds left_out;
  for (std::size_t i = 0; i < dropped.size(); ++i) {
    (dropped[i] ? left_out : rounded.kept).push_back(static_cast<std::uint32_t>(i));
  }
  if (rounded.kept.empty()) {
    throw UserError(input.path, "--drop leaves no triangle; use a finer --cell or drop less");
  }
  rounded.dropped = dropped_distance(mesh, defects, rounded.kept, left_out);
  mesh = part_of(mesh, rounded.kept);
}

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
double offered_length(const bake::SourceMesh& mesh) {
  const double length = bake::finest_cell(mesh) * 128;
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

InputMesh in_place_of(const InputMesh& input, const simplify::Coarsening& coarse) {
  InputMesh made;
  made.path = input.path;
  made.mesh = coarse.mesh();
  return made;
}

BakeOptions without_limit(BakeOptions options) {
  options.max_deviation = std::nullopt;
  return options;
}

}  // namespace

double finest_cell(const InputMesh& input) {
  return std::max(bake::finest_cell(input.mesh),
                  static_cast<double>(std::numeric_limits<float>::min()));
}

RoundedMesh round_mesh(const InputMesh& input, const BakeOptions& options) {
  const double cell = options.cell.value_or(finest_cell(input));
  check_range(input, cell, options);
  RoundedMesh rounded;
  rounded.lattice = bake::round_to_lattice(input.mesh, cell);
  rounded.lattice.deviation += input.reading_error();
  check_deviation(input, rounded.lattice, options, 0);
  rounded.defects = defects_of(input.mesh, rounded.lattice, input.degenerate);
  drop(rounded, input, options);
  rounded.lattice.deviation += rounded.dropped;
  check_deviation(input, rounded.lattice, options, rounded.dropped);
  return rounded;
}

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
  const double cell = options.cell.value_or(finest_cell(input));
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
                    offer_of(input, options, offered_length(input.mesh)),
                    options.offers_wide_indices ? "; or use --index-bits 32" : "");
  }
  return {build_tree(input, rounded, options), std::move(rounded.defects), rounded.dropped};
}

double coarse_bytes(const InputMesh& input, const simplify::Coarsening& coarse,
                    const BakeOptions& options, const std::string& name, bool levels) {
  const InputMesh made = coarse.is_original() ? input : in_place_of(input, coarse);
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
  MeshDefects defects = round_mesh(input, options).defects;
  const InputMesh made = in_place_of(input, coarse);
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
