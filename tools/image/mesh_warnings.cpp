#include "image/mesh_warnings.hpp"

#include <algorithm>
#include <cstdlib>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// "; kept (--drop degenerate leaves them out)" or "; left out".
std::string fate(bool dropped, const char* kind) {
  return dropped ? "; left out" : std::string("; kept (--drop ") + kind + " leaves them out)";
}

std::string edge_text(const EdgeDefects& edges) {
  std::string text;
  const auto add = [&](std::size_t count, const char* kind, const char* what) {
    if (count != 0) {
      text += concat((text.empty() ? "" : ", "), count, " ", kind,
                     (count == 1 ? "edge " : "edges "), what);
    }
  };
  add(edges.boundary, "boundary ", "of one triangle");
  add(edges.non_manifold, "non-manifold ", "of more than two");
  add(edges.twisted, "", "of two that face opposite ways");
  return text;
}

/// Three digits; large numbers are printed without an exponent.
std::string side_text(double side) {
  return side >= 100 && side < 1e9 ? fixed(side, 0) : significant(side, 3);
}

/// The ratio of a side to the median of all others; 1 if there are none. For an even number of
/// others, the nearer median counts.
double times_the_others(std::vector<double> sides, std::size_t which) {
  const double side = sides[which];
  sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(which));
  std::sort(sides.begin(), sides.end());
  if (sides.empty() || sides[(sides.size() - 1) / 2] <= 0) {
    return 1;
  }
  return side / std::clamp(side, sides[(sides.size() - 1) / 2], sides[sides.size() / 2]);
}

}  // namespace

void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings) {
  if (!defects.edges.none()) {
    warnings.add(path, std::string(defects.closed_before ? "once rounded " : "") +
                           "no closed surface (" + edge_text(defects.edges) +
                           "): what lies inside the solid is unknown" +
                           (defects.edges.twisted != 0 ? ", nor which way normals face" : "") +
                           (defects.closed_before ? "; a finer --cell keeps it closed" : ""));
  }
  if (defects.inside_out) {
    warnings.add(path,
                 "is inside out: normals face into the solid; turn the triangles round in the "
                 "program that made it, or leave them if it is a room, seen from within");
  } else if (defects.shells_inside_out != 0) {
    warnings.add(path, concat("has ", defects.shells_inside_out,
                              defects.shells_inside_out == 1 ? " part that is" : " parts that are",
                              " inside out: normals face into the solid, and where another part "
                              "overlaps it, points count as outside; turn its triangles round in "
                              "the program that made it"));
  }
}

void warn_of_mesh(const InputMesh& mesh, const MeshDefects& defects, const BakeOptions& options,
                  Warnings& warnings) {
  const std::string& path = mesh.path;
  const auto warn = [&](const TriangleIds& triangles, const char* what, bool dropped,
                        const char* kind) {
    if (!triangles.empty()) {
      warnings.add(path, what + triangle_list(triangles) + fate(dropped, kind));
    }
  };
  warn(defects.degenerate, "without area: ", options.drop_degenerate, "degenerate");
  warn(defects.collapsed, "without area once rounded: ", options.drop_degenerate, "degenerate");
  warn(defects.duplicates,
       "with the three vertices of an earlier one, once rounded: ", options.drop_duplicate,
       "duplicate");
  warn_of_surface(defects, path, warnings);
  if (options.cell) {
    warn_of_precision(mesh, *options.cell, warnings);
  }
}

void warn_of_precision(const InputMesh& mesh, double cell, Warnings& warnings) {
  if (mesh.precision > cell / 2) {
    warnings.add(mesh.path,
                 concat("its coordinates are read as 32-bit floats, which may be off by ",
                        shortest(mesh.precision), ", more than half a cell of ", shortest(cell),
                        "; export it as STL or PLY, or nearer to its origin"));
  }
}

void warn_of_place(const std::array<std::int32_t, 3>& origin, const std::string& path,
                   Warnings& warnings) {
  constexpr std::int64_t kFar = std::int64_t{1} << 18;
  std::int64_t distance = 0;
  std::int64_t farthest = 0;
  for (const std::int32_t cells : origin) {
    distance += std::abs(std::int64_t{cells});
    farthest = std::max(farthest, std::abs(std::int64_t{cells}));
  }
  if (distance > kFar || farthest >= kFar) {
    // The entries of a rotation are rounded to 2^-23, whatever the cell.
    const double off = static_cast<double>(distance) / (1 << 23);
    warnings.add(path, concat("lies far from its frame's origin: rotated, it is placed within ",
                              significant(0.51 + off, 2), " cells instead of 0.51",
                              farthest < kFar ? "" : ", and no motion of it can be queried",
                              "; move it nearer to the origin"));
  }
}

double longest_side(const Size& size) {
  return *std::max_element(size.begin(), size.end());
}

std::string size_text(const Size& size, const std::string& unit) {
  return concat(side_text(size[0]), " x ", side_text(size[1]), " x ", side_text(size[2]),
                unit.empty() ? "" : " ", unit);
}

std::vector<OddSize> odd_sizes(const std::vector<Size>& sizes) {
  std::vector<double> sides(sizes.size());
  std::transform(sizes.begin(), sizes.end(), sides.begin(), longest_side);
  std::vector<OddSize> odd;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double times = times_the_others(sides, i);
    if (times >= kOddSize || (times <= 1 / kOddSize && sides.size() > 2)) {
      odd.push_back({i, times});
    }
  }
  return odd;
}

std::string odd_size_text(const OddSize& odd, const std::string& others) {
  return concat(
      odd.times > 0 && odd.times < 1 ? "1/" + side_text(1 / odd.times) : side_text(odd.times),
      " times as long as the other ", others);
}

}  // namespace flashbvh::tool
