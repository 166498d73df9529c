// How large a robot's links are, and what looks like another unit, or is too coarse.
#ifndef FLASHBVH_TOOLS_CLI_ROBOT_SIZES_HPP
#define FLASHBVH_TOOLS_CLI_ROBOT_SIZES_HPP

#include <string>
#include <vector>

#include "cli/mesh/mesh_warnings.hpp"
#include "flashbvh/mesh.hpp"
#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// In metres, in the links' own frames.
std::vector<Size> link_sizes(const Model& model);
/// Of a model without meshes, by the baked ones. `cell`: theirs.
std::vector<Size> link_sizes(const Model& model, const Mesh* meshes, double cell);

/// Of links whose size is odd among the others, and of meshes that are all far larger than where
/// the joints lie. `path`: the URDF.
void warn_of_sizes(const Model& model, const std::vector<Size>& sizes, const std::string& path,
                   Warnings& warnings);

/// If the cell is coarser than a tenth of the stop distance, or a link has few cells. `place`: what
/// the cell follows from. Lengths are in metres.
void warn_of_cell(const Model& model, const std::vector<Size>& sizes, double cell, double stop,
                  const std::string& place, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
