// The setups of the paper's section 9, tables 2 to 8. Translation only. Each pose was chosen for
// what its table is about, by the counts of `volume-stack` and of the geometry; tests/scene holds
// each setup to it.
//
// The object in place of the paper's, which is not public, is a tumbler with a thick bottom,
// three-lobed, closed, with an outer and an inner wall, of 796 triangles as there.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "bake/mesh.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::scene {

constexpr std::uint32_t kPaperFaces = 796;
constexpr std::uint32_t kMaxSubdivisions = 4;

/// The rim's radius, without its lobes, of an object in full size; in cells.
constexpr std::int32_t kFullRadius = 12000;

/// How the tumbler is rotated when it is made; the bottom is at -z when upright.
enum class Orientation : std::uint8_t {
  upright,
  lying,        ///< a quarter of a turn about x: the bottom at +y
  upside_down,  ///< half a turn about x: the bottom at +z
};

struct PaperObject {
  std::uint32_t subdivisions;  ///< 0 to kMaxSubdivisions: each time a triangle becomes four
  std::int32_t radius;         ///< of the rim, in cells, at most kFullRadius
  Orientation orientation;

  constexpr std::uint32_t faces() const { return kPaperFaces << (2 * subdivisions); }
};

/// As in "upright_796_radius_12000".
std::string name_of(const PaperObject& object);

/// The mesh, the same on every machine; triangles turn counterclockwise seen from outside. The
/// vertices before the subdivision are multiples of 16 cells: all subdivisions are one surface.
bake::LatticeMesh make_mesh(const PaperObject& object);

struct Setup {
  std::uint32_t table;  ///< the paper's number, 2 to 8
  const char* name;     ///< as in the table
  PaperObject a;
  PaperObject b;
  Point translation;          ///< of B in A's frame, in cells
  std::uint32_t repetitions;  ///< the paper's, for one sample of the time
};

constexpr std::uint32_t kFirstTable = 2;
constexpr std::uint32_t kLastTable = 8;

/// In the order of the tables.
extern const std::array<Setup, 20> kSetups;

/// What a table is about, in a few words.
const char* table_title(std::uint32_t table);

}  // namespace flashbvh::scene
