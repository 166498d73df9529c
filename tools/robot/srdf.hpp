// What an SRDF says of pairs of links: that nobody shall look at them, and why.
#ifndef FLASHBVH_TOOLS_ROBOT_SRDF_HPP
#define FLASHBVH_TOOLS_ROBOT_SRDF_HPP

#include <string>
#include <vector>

#include "robot/model.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// The pairs of links that its <disable_collisions> name, each once, in its order. `all_links`: the
/// names of the URDF's links, with or without geometry; warns of others, and of a robot by another
/// name. UserError if the file is no SRDF.
std::vector<DisabledPair> read_srdf(const std::string& path, const Model& model,
                                    const std::vector<std::string>& all_links, Warnings& warnings);

}  // namespace flashbvh::tool

#endif
