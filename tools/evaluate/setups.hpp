// The setups of the paper's section 9, tables 2 to 8. Translation only. Each pose was chosen for
// its table's subject, by the counts of `volume-stack` and of the geometry; tests/scene verifies
// each setup.
//
// The paper's object is not public. A tumbler replaces it: thick bottom, three lobes, closed, with
// an outer and an inner wall, and 796 triangles like the paper's.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "bake/mesh.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::scene {

constexpr std::uint32_t kPaperFaces = 796;
constexpr std::uint32_t kMaxSubdivisions = 4;

/// The rim's radius of a full-size object, without its lobes, in cells.
constexpr std::int32_t kFullRadius = 12000;

/// The tumbler's rotation when it is made; the bottom of an upright one is at -z.
enum class Orientation : std::uint8_t {
  upright,
  lying,        ///< a quarter of a turn about x: the bottom at +y
  upside_down,  ///< half a turn about x: the bottom at +z
};

struct PaperObject {
  std::uint32_t subdivisions;  ///< 0 to kMaxSubdivisions: each turns a triangle into four
  std::int32_t radius;         ///< of the rim, in cells, at most kFullRadius
  Orientation orientation;

  constexpr std::uint32_t faces() const { return kPaperFaces << (2 * subdivisions); }
};

/// For example "upright_796_radius_12000".
std::string name_of(const PaperObject& object);

/// The mesh, equal on every machine; triangles are counterclockwise seen from outside. Vertices
/// before subdivision are multiples of 16 cells, so all subdivisions describe one surface.
bake::LatticeMesh make_mesh(const PaperObject& object);

struct Setup {
  std::uint32_t table;  ///< the paper's number, 2 to 8
  const char* name;     ///< as in the table
  PaperObject a;
  PaperObject b;
  Point translation;          ///< of B in A's frame, in cells
  std::uint32_t repetitions;  ///< of the paper, for one sample of the time
};

constexpr std::uint32_t kFirstTable = 2;
constexpr std::uint32_t kLastTable = 8;

/// In the order of the tables.
extern const std::array<Setup, 20> kSetups;

/// A table's subject, in a few words.
const char* table_title(std::uint32_t table);

}  // namespace flashbvh::scene
