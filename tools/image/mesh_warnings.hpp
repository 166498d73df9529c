// Warnings about baked meshes; sizes of meshes, and meshes that seem to be in another unit.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "image/baking.hpp"

namespace flashbvh::tool {

/// Adds a line for each kind of defect, and one if the mesh is known less exactly than the lattice
/// of `options.cell` can represent.
void warn_of_mesh(const InputMesh& mesh, const MeshDefects& defects, const BakeOptions& options,
                  Warnings& warnings);

/// Warns if the mesh is known less exactly than the lattice of `cell` can represent.
void warn_of_precision(const InputMesh& mesh, double cell, Warnings& warnings);

/// Warns of a surface that is not closed, not oriented, or inside out. `path`: the mesh or image.
void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings);

/// Warns if the mesh is so far from its frame's origin that rotations displace it by more than an
/// additional 1/32 cell. `origin`: of its lattice, in cells.
void warn_of_place(const std::array<std::int32_t, 3>& origin, const std::string& path,
                   Warnings& warnings);

/// The size of a mesh's bounding box along x, y and z.
using Size = std::array<double, 3>;

double longest_side(const Size& size);

/// "0.21 x 0.1 x 0.1 m", with three digits each. `unit` may be empty.
std::string size_text(const Size& size, const std::string& unit);

/// A mesh that is at least kOddSize times as long as the others' median, or at most 1/kOddSize.
constexpr double kOddSize = 50;
struct OddSize {
  std::size_t which;
  double times;  ///< multiple of the others' median, by the longest side
};

/// Odd sizes in ascending order. Of two meshes, only the larger one.
std::vector<OddSize> odd_sizes(const std::vector<Size>& sizes);

/// "1000 times as long as the other links", "1/400 times as long as ..."; `others`: "links".
std::string odd_size_text(const OddSize& odd, const std::string& others);

}  // namespace flashbvh::tool
