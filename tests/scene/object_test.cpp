// The object of the evaluation: its size, its walls, its subdivisions.
#include <map>
#include <set>

#include "evaluate/setups.hpp"
#include "support/test.hpp"

using scene::kFullRadius;
using scene::make_mesh;
using scene::Orientation;

namespace {

/// Whether each edge lies in exactly two triangles, which use it in opposite directions.
bool is_watertight(const bake::LatticeMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& [p, q, r] : mesh.triangles) {
    for (const auto& edge : {std::make_pair(p, q), std::make_pair(q, r), std::make_pair(r, p)}) {
      if (!edges.insert(edge).second) {
        return false;
      }
    }
  }
  for (const auto& edge : edges) {
    if (edges.count({edge.second, edge.first}) == 0) {
      return false;
    }
  }
  return true;
}

/// Six times the enclosed volume, in cells cubed; below 2^53 for every object here.
double six_volumes(const bake::LatticeMesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vertex& p = mesh.vertices[triangle[0]];
    const Vertex& q = mesh.vertices[triangle[1]];
    const Vertex& r = mesh.vertices[triangle[2]];
    sum += p.x * (1.0 * q.y * r.z - 1.0 * q.z * r.y) + p.y * (1.0 * q.z * r.x - 1.0 * q.x * r.z) +
           p.z * (1.0 * q.x * r.y - 1.0 * q.y * r.x);
  }
  return sum;
}

std::uint64_t hash_of(const bake::LatticeMesh& mesh) {
  std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a by numbers
  const auto mix = [&hash](std::uint32_t value) { hash = (hash ^ value) * 0x100000001B3u; };
  for (const Vertex& v : mesh.vertices) {
    mix(static_cast<std::uint16_t>(v.x));
    mix(static_cast<std::uint16_t>(v.y));
    mix(static_cast<std::uint16_t>(v.z));
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      mix(corner);
    }
  }
  return hash;
}

}  // namespace

TEST_CASE("the evaluation's object has 796 faces, four times as many with each subdivision") {
  std::uint32_t faces = 796;
  for (std::uint32_t i = 0; i <= scene::kMaxSubdivisions; ++i, faces *= 4) {
    const scene::PaperObject object = {i, kFullRadius, Orientation::upright};
    CHECK(object.faces() == faces);
    CHECK(make_mesh(object).triangles.size() == faces);
  }
}

TEST_CASE("the evaluation's object is watertight and turned outwards, however it is made") {
  for (std::uint32_t i = 0; i <= test::rounds<std::uint32_t>(1, scene::kMaxSubdivisions); ++i) {
    for (const auto orientation :
         {Orientation::upright, Orientation::lying, Orientation::upside_down}) {
      const bake::LatticeMesh mesh = make_mesh({i, kFullRadius, orientation});
      CHECK(is_watertight(mesh));
      CHECK(six_volumes(mesh) > 0);
      // Euler: a closed surface without a handle.
      CHECK(mesh.vertices.size() == mesh.triangles.size() / 2 + 2);
    }
  }
}

TEST_CASE("the evaluation's object is the same on every machine") {
  CHECK(hash_of(make_mesh({0, kFullRadius, Orientation::upright})) == 0x9A5A1973B117DAC3u);
  CHECK(hash_of(make_mesh({0, kFullRadius, Orientation::lying})) == 0x4D928CF26689A163u);
  CHECK(hash_of(make_mesh({0, kFullRadius, Orientation::upside_down})) == 0x3EC8A99300ED4503u);
  CHECK(hash_of(make_mesh({0, kFullRadius / 10, Orientation::upright})) == 0x4F0FB3FF46C7F7B3u);
}
