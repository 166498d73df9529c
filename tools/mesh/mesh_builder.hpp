// The readers of mesh files, and what they make their meshes with.
//
// STL, OBJ, PLY and OFF are read here: strictly, in double precision, each number of a text as the
// double nearest to it, each number of a binary as it is. assimp reads the others. It repairs what
// it cannot read and reports that in its log alone, and its coordinates are 32-bit floats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

using Position = std::array<double, 3>;

/// A mesh as its file has it.
struct FileMesh {
  bake::SourceMesh mesh;
  std::vector<std::string> bodies;     ///< those with triangles: names as in the file, maybe equal
  std::vector<std::uint32_t> body_of;  ///< each triangle's, as an index of `bodies`
  double precision = 0;                ///< how far the reader may have rounded a coordinate
  std::vector<std::string> warnings;   ///< what the user should know
};

/// Joins vertices where they are equal, in order of first use; cuts polygons into triangles in
/// place. Leaves out no triangle, and all points that no polygon uses.
class MeshBuilder {
 public:
  /// `file`: for messages.
  explicit MeshBuilder(std::string file) : file_(std::move(file)) {}

  void add_point(const Position& point) { points_.push_back({point, kUnused}); }
  std::size_t point_count() const { return points_.size(); }
  /// Of three or more points, which must be there.
  void add_polygon(const std::vector<std::uint32_t>& points);
  /// Apart from the points.
  void add_triangle(const std::array<Position, 3>& corners);

  /// What is added from now on is of another body, or of one that was begun before.
  std::uint32_t begin_body(std::string_view name);
  void resume_body(std::uint32_t body) { body_ = body; }

  /// UserError if there is no triangle. The builder is empty then.
  FileMesh finish();

 private:
  static constexpr std::uint32_t kUnused = 0xFFFFFFFF;
  struct FilePoint {
    Position position;
    std::uint32_t vertex;  ///< of the mesh, from its first use on
  };

  void leave_out_empty_bodies();
  std::uint32_t vertex_at(const Position& position);
  std::uint32_t vertex_of(FilePoint& point);
  void add(const bake::TriangleCorners& triangle);

  std::string file_;
  std::vector<FilePoint> points_;
  std::map<Position, std::uint32_t> vertex_at_;
  std::uint32_t body_ = kUnused;  ///< none begun
  FileMesh built_;
};

/// Each body's, as if the file held no other.
std::vector<bake::SourceMesh> meshes_of_bodies(const FileMesh& whole);

/// The coordinate `word`, to half a unit in the last place, at `place`. UserError if it is no
/// number or none that is_coordinate().
double coordinate(std::string_view word, const std::string& file, std::size_t line);

/// Whether a float can hold it: firmware's lengths are floats.
bool is_coordinate(double value);

// Each takes the bytes of a file and its name for messages. UserError if the file is damaged or of
// another format, or has no polygons.

/// Binary and ASCII. A body is a `solid`.
FileMesh read_stl(std::string_view bytes, const std::string& file);
/// A body is what the last `o` or `g` line names.
FileMesh read_obj(std::string_view bytes, const std::string& file);
/// One body.
FileMesh read_off(std::string_view bytes, const std::string& file);
/// ASCII and binary. One body.
FileMesh read_ply(std::string_view bytes, const std::string& file);

/// The formats that assimp reads, from the file itself, for what it may refer to. A body is a node.
FileMesh read_with_assimp(std::string_view bytes, const std::string& file);

/// Warns if a text file does not end with a line end: its last number may have lost digits, which
/// nothing else shows.
void warn_of_cut_line(std::string_view text, FileMesh& mesh);

}  // namespace flashbvh::tool
