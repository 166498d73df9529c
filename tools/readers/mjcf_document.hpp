// An MJCF reduced to a robot's shapes and joints. So files for newer MuJoCo can be read, too, whose
// actuators and materials Debian's MuJoCo does not know.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace flashbvh::tool {

struct MjcfDocument {
  std::string text;                               ///< with includes inserted
  std::vector<std::string> files;                 ///< includes and meshes that exist
  std::map<std::string, std::string> mesh_files;  ///< as in the MJCF, by the mesh's name
  std::set<std::string> dropped;                  ///< names of elements left out
};

/// UserError if the file or an included one is no XML, or has a <compiler> with an unknown
/// attribute, which may change shapes.
MjcfDocument read_mjcf_document(const std::string& path);

}  // namespace flashbvh::tool
