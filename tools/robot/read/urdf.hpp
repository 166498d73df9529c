// A robot of a URDF, MJCF or SDF, with its meshes and its SRDF, as a Model.
#pragma once

#include <string>
#include <vector>

#include "robot/model.hpp"
#include "robot/read/link_mesh.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// `srdf`, `joint_limits`: files, or empty. UserError, with the element and the remedy, for all
/// that is no robot or that firmware can't hold; warnings of elements that do not count.
/// `visual_too`: links that have visual shapes alone collide by them.
Model read_urdf(const std::string& path, const Packages& packages, const std::string& srdf,
                Warnings& warnings, const std::string& joint_limits = "", bool visual_too = false);

/// The pairs of links that its <disable_collisions> name, each once, in its order; then those of
/// links in <disable_default_collisions> but for pairs in <enable_collisions>. `all_links`: the
/// names of the URDF's links, with or without geometry; warns of others, of a robot by another name
/// and of a pair both enabled and disabled, which is disabled. UserError if the file is no SRDF.
std::vector<DisabledPair> read_srdf(const std::string& path, const Model& model,
                                    const std::vector<std::string>& all_links, Warnings& warnings);

}  // namespace flashbvh::tool
