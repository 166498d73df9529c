// The links of a robot baked, all with one cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bake/image_bytes.hpp"
#include "image/baking.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

struct BakedLink {
  bake::BakedTree<std::uint16_t, Layout::post_indexed> tree;
  MeshDefects defects;

  /// A view of the tree, in the frame of the link's joint.
  Mesh mesh() const { return tree.view(); }
  std::size_t image_bytes() const { return static_cast<std::size_t>(bake::image_size(tree)); }
};

/// Of all images together.
std::size_t image_bytes(const std::vector<BakedLink>& links);

/// UserError if the robot has more joints or links than firmware holds. `path`: the URDF.
void check_counts(const Model& model, const std::string& path);

/// In metres: the finest with which all links fit the lattice, and all joints, wherever they stand,
/// firmware's frames and sums; or `wanted`. UserError if that is too fine for links or frames.
double robot_cell(const Model& model, const std::optional<double>& wanted, const std::string& path);

/// As it is baked, in metres, for messages.
InputMesh link_input(const ModelLink& link, const std::string& path);

/// In metres: how far a point of the baked link may lie from where the URDF has it, by what
/// rounding to the lattice moved its vertices and by what the reader rounded.
double link_deviation(const ModelLink& link, double cell);

/// UserError, with the link and the remedy, if it has more triangles than 16-bit indices reach;
/// says what simplifying would leave.
void check_triangles(const ModelLink& link, double cell, const std::string& path);

/// Whether 16-bit indices reach all of such a tree.
bool fits_firmware(const BakedPart& part);

/// In metres: the same of a link that is baked for firmware, simplified or not.
double firmware_deviation(const ModelLink& link, const BakedLink& baked);

/// For firmware. UserError, with the link and the remedy, if it has more triangles, vertices or
/// nodes than 16-bit indices reach. `leaf_size`: most triangles in a leaf. `coarse`: of the link's
/// mesh, to be baked in its place, or null.
BakedLink bake_link(const ModelLink& link, double cell, std::uint32_t leaf_size,
                    const std::string& path, const simplify::Coarsening* coarse = nullptr);

}  // namespace flashbvh::tool
