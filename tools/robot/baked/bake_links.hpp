// Bakes the links of a robot, all with one cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bake/image_bytes.hpp"
#include "image/baking.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// A link for firmware, in the frame of its joint.
using BakedLink = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

/// UserError if the robot has no joint, or more joints or links than firmware holds. `path`: the
/// URDF.
void check_counts(const Model& model, const std::string& path);

/// The cell in metres: `wanted`, or the finest with which links fit the lattice, and joints in all
/// configurations fit firmware's frames and sums. UserError if `wanted` is too fine for frames.
double robot_cell(const Model& model, const std::optional<double>& wanted, const std::string& path);

/// The link's mesh as baking takes it, in metres, with its name for messages.
InputMesh link_input(const ModelLink& link, const std::string& path);

/// A bound, in metres, on the distance of a baked link's points from their place in the URDF:
/// rounding to the lattice, and the reader's rounding.
double link_deviation(const ModelLink& link, double cell);

/// True if 16-bit indices reach all elements of the part.
bool fits_firmware(const BakedPart& part);

/// Bakes a link for firmware. UserError, with the link and the remedy, if it has more triangles,
/// vertices or nodes than 16-bit indices reach. `leaf_size`: most triangles in a leaf. `coarse`: a
/// simplification of the link's mesh to bake in its place, or null.
BakedLink bake_link(const ModelLink& link, double cell, std::uint32_t leaf_size,
                    const std::string& path, const simplify::Coarsening* coarse = nullptr);

}  // namespace flashbvh::tool
