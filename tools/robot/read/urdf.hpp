// Reads a URDF, with its meshes and its SRDF, into a Model.
#pragma once

#include <string>
#include <vector>

#include "robot/model.hpp"
#include "robot/read/link_mesh.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// `srdf`: a file, or empty. UserError, with the element and the remedy, for files
/// that are no robot or that firmware can't hold; warns of ignored elements. `visual_too`: links
/// with visual shapes alone collide by them.
Model read_urdf(const std::string& path, const Packages& packages, const std::string& srdf,
                Warnings& warnings, bool visual_too = false);

/// The disabled pairs of links, each once: those of <disable_collisions>, in the file's order; then
/// those of links in <disable_default_collisions> except pairs in <enable_collisions>. Warns of
/// unknown links, of another robot's name, and of a pair both enabled and disabled, which is
/// disabled. UserError if the file is no SRDF.
std::vector<DisabledPair> read_srdf(const std::string& path, const Model& model,
                                    Warnings& warnings);

}  // namespace flashbvh::tool
