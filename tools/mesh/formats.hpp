// What stands between a mesh file and assimp.
//
// assimp mends what it can't read, and tells nobody but its log: it takes an STL file that was cut
// off for a shorter mesh, leaves out vertices and faces it doesn't like, and moves an index that is
// out of range to the last vertex. So each format is read here first, strictly, and refused with
// the place of the fault. Text formats go on to assimp in a plain form in which nothing is left to
// mend: numbers as they are in the file, one mesh, faces in the order of the file.
#ifndef FLASHBVH_TOOLS_MESH_FORMATS_HPP
#define FLASHBVH_TOOLS_MESH_FORMATS_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace flashbvh::tool {

/// A mesh file ready for assimp.
struct MeshText {
  std::string bytes;
  std::size_t face_count = 0;  ///< what assimp must find: polygons of at least three corners
  std::string warning;         ///< what the user should know, if anything
};

// Each takes the bytes of a file and its name for messages. UserError if the file is damaged or of
// another format, or has no faces.

/// Binary STL as it is; ASCII STL plain.
MeshText plain_stl(std::string bytes, const std::string& file);
/// Vertices and faces alone: no groups or materials, by which assimp would sort the faces.
MeshText plain_obj(std::string bytes, const std::string& file);
/// Vertices without colours and normals; faces.
MeshText plain_off(std::string bytes, const std::string& file);
/// As it is, ASCII or binary.
MeshText plain_ply(std::string bytes, const std::string& file);

/// A warning if a text file does not end with a line end, else nothing: its last number may have
/// lost digits, which nothing else tells.
std::string warn_of_cut_line(std::string_view text);

/// Adds a blank and the coordinate `word`, found on `line` of `file`. UserError if it is no finite
/// number.
void append_coordinate(std::string& bytes, std::string_view word, const std::string& file,
                       std::size_t line);

}  // namespace flashbvh::tool

#endif
