// What a reader can't make out is refused, with its place.
#include <catch2/catch.hpp>

#include "mesh/any_format.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// The triangle, with one thing in its header or body replaced.
std::string ply_with(const std::string& what, const std::string& by) {
  std::string text = kPlyHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  return text.replace(text.find(what), what.size(), by);
}

std::string said_of_ply(const std::string& what, const std::string& by) {
  return refusal(tool::read_ply, ply_with(what, by));
}

}  // namespace

TEST_CASE("PLY: the shape must be whole and without a second meaning") {
  const std::string mend = "; export the mesh again";
  CHECK(said_of_ply("ply", "ply") == "");
  CHECK(said_of_ply("element face 1",
                    "element tristrips 2\nproperty list int int vertex_indices\n"
                    "element face 1") ==
        "file: has triangle strips ('tristrips'); export the mesh as polygons");
  for (const std::string axis : {"x", "y", "z"}) {
    CHECK(said_of_ply("double " + axis, "double w") ==
          "file: has vertices without a number '" + axis + "'" + mend);
    CHECK(said_of_ply("double " + axis, "list uchar int " + axis) ==
          "file: has vertices without a number '" + axis + "'" + mend);
  }
  CHECK(said_of_ply("element face 1", "element vertex 1\nproperty float x\nelement face 1") ==
        "file:7: a second element 'vertex'" + mend);
  CHECK(said_of_ply("double z", "double y") == "file:6: a second property 'y'" + mend);
  CHECK(said_of_ply("vertex_indices", "corners") ==
        "file: has faces without one list of integers 'vertex_indices'" + mend);
  CHECK(said_of_ply("uchar int vertex_indices", "uchar float vertex_indices") ==
        "file: has faces without one list of integers 'vertex_indices'" + mend);
  CHECK(said_of_ply("uchar int vertex_indices", "float int vertex_indices") ==
        "file:8: a list whose length is no integer" + mend);
  CHECK(said_of_ply("format ascii 1.0\n", "") ==
        "file:8: the header ends without a 'format'" + mend);
  CHECK(said_of_ply("element face 1\nproperty list uchar int vertex_indices\n", "") ==
        "file: has no polygons ('vertex' and 'face')" + mend);
}

TEST_CASE("PLY: each number must be of its type") {
  const std::string mend = "; export the mesh again";
  CHECK(said_of_ply("3 0 1 2", "3 0 1.5 2") == "file: face 0 of 1: '1.5' is no int" + mend);
  CHECK(said_of_ply("3 0 1 2", "3 0 1 2.0") == "file: face 0 of 1: '2.0' is no int" + mend);
  CHECK(said_of_ply("3 0 1 2", "3.0 0 1 2") == "file: face 0 of 1: '3.0' is no uchar" + mend);
  CHECK(said_of_ply("3 0 1 2", "3 0 1 -1") ==
        "file: face 0 of 1: a corner at vertex -1 of 3" + mend);
  CHECK(said_of_ply("3 0 1 2", "3 0 1 18446744073709551616") ==
        "file: face 0 of 1: '18446744073709551616' is no int" + mend);
  CHECK(said_of_ply("3 0 1 2", "2 0 1") == "file: face 0 of 1: a polygon of 2 corners" + mend);
  CHECK(said_of_ply("1 0 0", "1 nan 0") == "file: vertex 1 of 3: 'nan' is no finite double" + mend);
  CHECK(said_of_ply("3 0 1 2\n", "3 0 1 2\n7\n") ==
        "file: has more than its header announces" + mend);
  CHECK(said_of_ply("double x", "int x") == "");
  CHECK(refusal(tool::read_ply,
                ply_with("double x", "int x")
                    .replace(ply_with("double x", "int x").find("1 0 0"), 1, "1.5")) ==
        "file: vertex 1 of 3: '1.5' is no int" + mend);
}

TEST_CASE("OBJ: a corner is an integer") {
  for (const std::string corner : {".5", "1.0", "1.", "0", "4", "-4", "18446744073709551617", "1e0",
                                   "+", "x", "/1", "9223372036854775807", "-9223372036854775808"}) {
    CHECK(refusal(tool::read_obj, kVertices + "f 1 2 " + corner + "\n") ==
          "file:4: a corner at vertex '" + corner +
              "', but there are 3 vertices so far; export the mesh again");
  }
  CHECK(refusal(tool::read_obj, kVertices + "f 1 2 +3\n") == "");
}

TEST_CASE("OFF: polygons of any number of corners, at vertices that are there") {
  const std::string points =
      "0 0 0\n4 0 0\n5 1 0\n5 2 0\n4 3 0\n3 4 0\n2 5 0\n1 5 0\n0 4 0\n-1 3 0\n";
  const auto file = tool::read_off("OFF\n10 1 0\n" + points + "10 0 1 2 3 4 5 6 7 8 9\n", "file");
  CHECK(file.mesh.triangles.size() == 8);
  CHECK(refusal(tool::read_off, "OFF\n10 1 0\n" + points + "3 0 1 .5\n") ==
        "file:13: a corner at vertex '.5', but there are 10 vertices; export the mesh again");
  CHECK(refusal(tool::read_off, "OFF\n10 1 0\n" + points + "2 0 1\n") ==
        "file:13: a polygon of '2' corners; it must have three or more");
  CHECK(refusal(tool::read_off, "OFF\n10 1 0\n" + points + "9223372036854775807 0 1\n") ==
        "file:13: a polygon of 9223372036854775807 corners names only 2; export the mesh again");
}
