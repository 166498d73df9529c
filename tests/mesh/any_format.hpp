// Files of meshes: one triangle in each text format, and what readers say of changed ones.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
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

inline const std::array<TextFormat, 3> kTextFormats = {
    {{"stl", tool::read_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex ",
      "vertex 7 0 0\nvertex 0 7 0\nendloop\nendfacet\nendsolid\n"},
     {"obj", tool::read_obj, "v ", "v 7 0 0\nv 0 7 0\nf 1 2 3\n"},
     {"ply", tool::read_ply, kPlyHeader, "7 0 0\n0 7 0\n3 0 1 2\n"}}};

/// The message of a reader that refuses a file; empty if it reads the file.
template <class Read>
std::string refusal(Read read, const std::string& bytes, const std::string& file = "file") {
  try {
    (void)read(bytes, file);
    return {};
  } catch (const tool::UserError& error) {
    return error.what();
  }
}

/// The text with `part`, which must be in it, replaced.
inline std::string with(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

/// Six times the volume that a mesh encloses; negative if it is inside out.
inline double volume6(const tool::FileMesh& file) {
  double sum = 0;
  for (const auto& [i, j, k] : file.mesh.triangles) {
    const tool::Position& a = file.mesh.vertices[i];
    const tool::Position& b = file.mesh.vertices[j];
    const tool::Position& c = file.mesh.vertices[k];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/// The number's bytes, the least first unless `big`.
template <class Number>
std::string bytes_of(Number number, bool big = false) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  if (big) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

}  // namespace flashbvh::test
