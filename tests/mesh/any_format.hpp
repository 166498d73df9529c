// One triangle as text, in each text format.
#pragma once

#include <array>
#include <string>

#include "mesh/mesh_builder.hpp"
#include "text/messages.hpp"

namespace flashbvh::test {

/// A header for doubles.
inline const std::string kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

struct TextFormat {
  const char* name;
  tool::FileMesh (*read)(std::string_view, const std::string&);
  std::string before;  ///< the triangle's first vertex: "x y z\n"
  std::string after;
};

inline const std::array<TextFormat, 4> kTextFormats = {
    {{"stl", tool::read_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex ",
      "vertex 7 0 0\nvertex 0 7 0\nendloop\nendfacet\nendsolid\n"},
     {"obj", tool::read_obj, "v ", "v 7 0 0\nv 0 7 0\nf 1 2 3\n"},
     {"off", tool::read_off, "OFF\n3 1 0\n", "7 0 0\n0 7 0\n3 0 1 2\n"},
     {"ply", tool::read_ply, kPlyHeader, "7 0 0\n0 7 0\n3 0 1 2\n"}}};

/// The message of a reader that refuses a file; empty if it reads the file.
template <class Read>
std::string refusal(Read read, const std::string& bytes) {
  try {
    (void)read(bytes, std::string("file"));
    return {};
  } catch (const tool::UserError& error) {
    return error.what();
  }
}

}  // namespace flashbvh::test
