// Bodies of a file: which triangles are whose, and what a body is by itself.
#include <catch2/catch.hpp>

#include "mesh/any_format.hpp"

using namespace flashbvh;
using tool::FileMesh;
using Names = std::vector<std::string>;
using Numbers = std::vector<std::uint32_t>;

namespace {

std::string facet(int z) {
  const std::string height = " " + std::to_string(z) + "\n";
  return "facet normal 0 0 1\nouter loop\nvertex 0 0" + height + "vertex 1 0" + height +
         "vertex 0 1" + height + "endloop\nendfacet\n";
}

}  // namespace

TEST_CASE("ASCII STL: a body is a solid, by its name as it is written; empty ones are none") {
  const FileMesh file =
      tool::read_stl("solid Left  Wheel \n" + facet(0) + facet(1) +
                         "endsolid Left  Wheel\nsolid empty\nendsolid\n" + "SOLID\n" + facet(0) +
                         "ENDSOLID\nsolid Left  Wheel\n" + facet(2) + "endsolid other\n",
                     "file");
  CHECK(file.bodies == Names{"Left  Wheel", "", "Left  Wheel"});
  CHECK(file.body_of == Numbers{0, 0, 1, 2});
  const auto meshes = tool::meshes_of_bodies(file);
  REQUIRE(meshes.size() == 3);
  CHECK(meshes[0].triangles.size() == 2);
  CHECK(meshes[0].vertices.size() == 6);
  CHECK(meshes[1].vertices.size() == 3);  // one of the first body's triangles, of its own here
  CHECK(meshes[2].vertices.at(0) == tool::Position{0, 0, 2});
}

TEST_CASE("OBJ: a body is what the last o or g names, and goes on where it is named again") {
  const FileMesh file = tool::read_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\no base plate\nf 1 2 4\ng arm \\\n left\n"
      "f 1 3 4\no base plate\nf 2 3 4\ng\nf 1 2 4\no none\n",
      "file");
  CHECK(file.bodies == Names{"", "base plate", "arm   left"});
  CHECK(file.body_of == Numbers{0, 1, 2, 1, 0});
}

TEST_CASE("PLY and OFF: one body without a name") {
  CHECK(tool::read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "file").bodies == Names{""});
  CHECK(tool::read_ply(test::kPlyHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "file").bodies ==
        Names{""});
}
