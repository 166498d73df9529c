#include "image/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <set>

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

void check_deviation(const InputMesh& input, const RoundedMesh& rounded,
                     const BakeOptions& options) {
  const std::optional<double>& most = options.max_deviation;
  if (!most || rounded.lattice.deviation <= *most) {
    return;
  }
  const double moved = rounded.lattice.deviation - rounded.dropped;
  if (moved <= *most) {
    throw UserError(input.path, "triangles to drop lie up to ", text_of(rounded.dropped, options),
                    " from all others, --max-deviation allows ", text_of(*most, options),
                    "; leave --drop out, or repair the mesh");
  }
  const double cell = sure_cell(*most - input.reading_error());
  throw UserError(input.path, "rounding moves a vertex by ", text_of(moved, options),
                  ", --max-deviation allows ", text_of(*most, options),
                  cell >= input.finest_cell
                      ? "; a cell of " + text_of(cell, options) + " or less keeps to that"
                      : "; the mesh is too large for so fine a cell: cut or convert it: --unit");
}

/// A triangle, an edge or a point, by its corners in any order: the same for the same corners.
bake::TriangleCorners form_of(std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  bake::TriangleCorners corners = {p, q, r};
  std::sort(corners.begin(), corners.end());
  corners[1] = corners[1] == corners[2] ? corners[0] : corners[1];
  return corners;
}

/// RoundedMesh::dropped. A triangle without area in the file is a line there, once rounded too.
double dropped_distance(const bake::LatticeMesh& mesh, const MeshDefects& defects,
                        const TriangleIds& kept, const TriangleIds& dropped) {
  std::set<bake::TriangleCorners> covered;
  for (const std::uint32_t triangle : kept) {
    const auto& [p, q, r] = mesh.triangles[triangle];
    covered.insert({form_of(p, q, r), form_of(p, p, q), form_of(q, q, r), form_of(r, r, p),
                    form_of(p, p, p), form_of(q, q, q), form_of(r, r, r)});
  }
  TriangleIds apart;
  for (const std::uint32_t triangle : dropped) {
    const auto& [p, q, r] = mesh.triangles[triangle];
    const auto is_in = [&](const TriangleIds& ids) {
      return std::binary_search(ids.begin(), ids.end(), triangle);
    };
    const bool is_line = is_in(defects.degenerate) || is_in(defects.collapsed);
    // Two edges of a triangle without area contain the third.
    const std::size_t edges = covered.count(form_of(p, p, q)) + covered.count(form_of(q, q, r)) +
                              covered.count(form_of(r, r, p));
    if (covered.count(form_of(p, q, r)) == 0 && !(is_line && edges >= 2)) {
      apart.push_back(triangle);
    }
  }
  return apart.empty() ? 0
                       : simplify::farthest_from(source_of(part_of(mesh, kept)),
                                                 source_of(part_of(mesh, apart)));
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

}  // namespace

std::string text_of(double length, const BakeOptions& options) {
  return shortest(length) + (options.unit.empty() ? "" : " " + options.unit);
}

bake::LatticeMesh lattice_of(const InputMesh& input, const BakeOptions& options) {
  const double cell = options.cell.value_or(input.finest_cell);
  if (!bake::fits(input.extent, cell)) {
    throw UserError(input.path, "is too large for a cell of ", text_of(cell, options),
                    "; the finest that it fits is --cell ", shortest(input.finest_cell));
  }
  return bake::round_to_lattice(input.mesh, input.extent, cell);
}

RoundedMesh round_mesh(const InputMesh& input, const BakeOptions& options) {
  RoundedMesh rounded;
  rounded.lattice = lattice_of(input, options);
  rounded.lattice.deviation += input.reading_error();
  rounded.defects = defects_of(input.mesh, rounded.lattice, input.degenerate);
  drop(rounded, input, options);
  rounded.lattice.deviation += rounded.dropped;
  check_deviation(input, rounded, options);
  return rounded;
}

}  // namespace flashbvh::tool
