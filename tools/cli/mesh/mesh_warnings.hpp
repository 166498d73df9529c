// What is said of a mesh that was baked; how large meshes are, and which look like another unit.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bake/mesh.hpp"
#include "image/baking.hpp"

namespace flashbvh::tool {

/// A line for each kind of defect, and one if the mesh is known less exactly than the lattice of
/// `options.cell` can represent.
void warn_of_mesh(const InputMesh& mesh, const MeshDefects& defects, const BakeOptions& options,
                  Warnings& warnings);

/// If the mesh is known less exactly than the lattice of `cell` can represent.
void warn_of_precision(const InputMesh& mesh, double cell, Warnings& warnings);

/// Of a surface that is not closed, or not oriented, or inside out. `path`: the mesh or image.
void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings);

/// If the mesh lies so far from its frame's origin that rotations place it less exactly by more
/// than 1/32 cell. `origin`: of its lattice, in cells.
void warn_of_place(const std::array<std::int32_t, 3>& origin, const std::string& path,
                   Warnings& warnings);

/// Of a box that holds a mesh, along x, y and z.
using Size = std::array<double, 3>;

/// In the mesh's unit; zeros if it has no vertex.
Size size_of(const bake::SourceMesh& mesh);

/// "0.21 x 0.1 x 0.1 m", three digits each. `unit` may be empty.
std::string size_text(const Size& size, const std::string& unit);

/// A mesh that is at least kOddSize times as long as the others' median, or at most 1/kOddSize.
constexpr double kOddSize = 50;
struct OddSize {
  std::size_t which;
  double times;  ///< the others' median, by the longest side
};

/// In ascending order. Of two meshes the larger one alone.
std::vector<OddSize> odd_sizes(const std::vector<Size>& sizes);

/// "1000 times as long as the other links", "1/400 times as long as ..."; `others`: "links".
std::string odd_size_text(const OddSize& odd, const std::string& others);

}  // namespace flashbvh::tool
