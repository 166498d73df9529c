// The object of the evaluation: its size, its walls, its subdivisions.
#include "evaluate/setups.hpp"
#include "mesh/defects.hpp"
#include "support/test.hpp"

using scene::kFullRadius;
using scene::make_mesh;
using scene::Orientation;

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
      const tool::MeshDefects defects = tool::surface_defects(mesh);
      CHECK((defects.edges.none() && !defects.inside_out));
      // Euler: a closed surface without a handle.
      CHECK(mesh.vertices.size() == mesh.triangles.size() / 2 + 2);
    }
  }
}
