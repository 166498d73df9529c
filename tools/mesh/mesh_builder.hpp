// The readers of mesh files, and the builder of their meshes.
//
// STL, OBJ, PLY and 3MF are read here: strictly, in double precision. Numbers of a text are
// rounded to the nearest double; binary numbers are read unchanged. assimp reads DAE and glTF. It
// repairs faults and reports them in its log alone, and its coordinates are 32-bit floats: what it
// would misread is refused before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bake/mesh.hpp"
#include "mesh/placement.hpp"

namespace flashbvh::tool {

using Position = std::array<double, 3>;

/// A mesh as read from its file.
struct FileMesh {
  bake::SourceMesh mesh;
  Unit unit = Unit::none;             ///< of the numbers, if the file or its format says so
  double precision = 0;               ///< bound on the reader's rounding of a coordinate
  std::vector<std::string> warnings;  ///< for the user
};

/// Joins equal vertices, in order of first use; cuts polygons into triangles in place. Keeps all
/// triangles, and omits points that no polygon uses.
class MeshBuilder {
 public:
  /// `file`: for messages.
  explicit MeshBuilder(std::string file) : file_(std::move(file)) {}

  /// Begins a part whose points are placed. Mirrored polygons keep their outside.
  void begin_part(const Placement& placement);
  /// UserError for a placed point that is_coordinate() refuses.
  void add_point(const Position& point);
  /// Of the part.
  std::size_t point_count() const { return points_.size() - first_; }
  /// Adds a polygon of three or more points of the part, which must exist.
  void add_polygon(const std::vector<std::uint32_t>& points);
  /// Adds a triangle that does not refer to points.
  void add_triangle(const std::array<Position, 3>& corners);

  /// Counts a point or a line, which the mesh leaves out with a warning.
  void leave_out() { ++left_out_; }

  /// Returns the mesh and empties the builder. UserError if there is no triangle.
  FileMesh finish();
  /// The largest sum of a placed coordinate's absolute summands.
  double largest() const { return largest_; }

 private:
  Position placed(const Position& point);
  std::uint32_t vertex_at(const Position& position);

  std::string file_;
  std::vector<Position> points_;
  std::size_t first_ = 0;  ///< of the part's points
  std::optional<Placement> placement_;
  double largest_ = 0;
  std::map<Position, std::uint32_t> vertex_at_;
  std::size_t left_out_ = 0;
  FileMesh built_;
};

/// Parses a coordinate to half a unit in the last place. UserError, at the line, if `word` is no
/// number or one that is_coordinate() refuses.
double coordinate(std::string_view word, const std::string& file, std::size_t line);

/// True if a float can hold the value: firmware's lengths are floats.
bool is_coordinate(double value);

/// UserError if the first bytes are those of an archive, of UTF-16 or of another kind of file.
/// Binary STLs may begin with any bytes.
void refuse_other_contents(std::string_view bytes, const std::string& file);

/// A text without the NULs and Ctrl-Zs behind it, which pad files.
std::string_view without_padding(std::string_view text);

// Each reader takes the bytes of a file and its name for messages. UserError if the file is damaged
// or of another format, or has no polygons.

/// Binary and ASCII.
FileMesh read_stl(std::string_view bytes, const std::string& file);
FileMesh read_obj(std::string_view bytes, const std::string& file);
/// ASCII and binary.
FileMesh read_ply(std::string_view bytes, const std::string& file);

/// DAE and glTF: assimp reads the file itself, which may refer to other files.
FileMesh read_with_assimp(std::string_view bytes, const std::string& file);
FileMesh read_3mf(std::string_view bytes, const std::string& file);

/// Warns if a text file does not end with a line end: its last number may have lost digits without
/// another sign.
void warn_of_cut_line(std::string_view text, FileMesh& mesh);

}  // namespace flashbvh::tool
