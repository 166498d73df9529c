// What a reader can't make out is refused, with its place.
#include <catch2/catch.hpp>

#include "mesh/any_format.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kMend = "; export the mesh again";

/// The triangle, with one thing in its header or body replaced.
std::string ply_with(const std::string& what, const std::string& by) {
  std::string text = kPlyHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  return text.replace(text.find(what), what.size(), by);
}

/// `said` stands between "file" and the advice to export the mesh again.
struct BadPly {
  std::string what;
  std::string by;
  std::string said;
};

const std::string kList = "uchar int vertex_indices";
const std::string kNoList = ": has faces without one list of integers 'vertex_indices'";

const BadPly kBadPlies[] = {
    // The shape must be whole and without a second meaning.
    {"double x", "double w", ": has vertices without a number 'x'"},
    {"double y", "double w", ": has vertices without a number 'y'"},
    {"double z", "double w", ": has vertices without a number 'z'"},
    {"double x", "list uchar int x", ": has vertices without a number 'x'"},
    {"double y", "list uchar int y", ": has vertices without a number 'y'"},
    {"double z", "list uchar int z", ": has vertices without a number 'z'"},
    {"element face 1", "element vertex 1\nproperty float x\nelement face 1",
     ":7: a second element 'vertex'"},
    {"double z", "double y", ":6: a second property 'y'"},
    {"vertex_indices", "corners", kNoList},
    {kList, "uchar float vertex_indices", kNoList},
    {kList, "float int vertex_indices", ":8: a list whose length is no integer"},
    {"format ascii 1.0\n", "", ":8: the header ends without a 'format'"},
    {"element face 1\nproperty list " + kList + "\n", "",
     ": has no polygons ('vertex' and 'face')"},
    // Each number must be of its type.
    {"3 0 1 2", "3 0 1.5 2", ": face 0 of 1: '1.5' is no int"},
    {"3 0 1 2", "3 0 1 2.0", ": face 0 of 1: '2.0' is no int"},
    {"3 0 1 2", "3.0 0 1 2", ": face 0 of 1: '3.0' is no uchar"},
    {"3 0 1 2", "3 0 1 -1", ": face 0 of 1: a corner at vertex -1 of 3"},
    {"3 0 1 2", "3 0 1 18446744073709551616", ": face 0 of 1: '18446744073709551616' is no int"},
    {"3 0 1 2", "2 0 1", ": face 0 of 1: a polygon of 2 corners"},
    {"1 0 0", "1 nan 0", ": vertex 1 of 3: 'nan' is no finite double"},
    {"3 0 1 2\n", "3 0 1 2\n7\n", ": has more than its header announces"},
};

/// Polygons of an OFF with ten points.
const std::array<std::array<std::string, 2>, 3> kBadOffs = {{
    {"3 0 1 .5", ": a corner at vertex '.5', but there are 10 vertices" + kMend},
    {"2 0 1", ": a polygon of '2' corners; it must have three or more"},
    {"9223372036854775807 0 1", ": a polygon of 9223372036854775807 corners names only 2" + kMend},
}};

}  // namespace

TEST_CASE("PLY: what is malformed") {
  CHECK(refusal(tool::read_ply, ply_with("ply", "ply")) == "");
  CHECK(refusal(tool::read_ply, ply_with("double x", "int x")) == "");
  for (const auto& [what, by, said] : kBadPlies) {
    CAPTURE(what, by);
    CHECK(refusal(tool::read_ply, ply_with(what, by)) == "file" + said + kMend);
  }
  std::string ints = ply_with("double x", "int x");
  ints.replace(ints.find("1 0 0"), 1, "1.5");
  CHECK(refusal(tool::read_ply, ints) == "file: vertex 1 of 3: '1.5' is no int" + kMend);
  CHECK(
      refusal(tool::read_ply, ply_with("element face 1",
                                       "element tristrips 2\nproperty list int int vertex_indices\n"
                                       "element face 1")) ==
      "file: has triangle strips ('tristrips'); export the mesh as polygons");
}

TEST_CASE("OBJ: a corner is an integer") {
  for (const std::string corner : {".5", "1.0", "1.", "0", "4", "-4", "18446744073709551617", "1e0",
                                   "+", "x", "/1", "9223372036854775807", "-9223372036854775808"}) {
    CHECK(refusal(tool::read_obj, kVertices + "f 1 2 " + corner + "\n") ==
          "file:4: a corner at vertex '" + corner + "', but there are 3 vertices so far" + kMend);
  }
  CHECK(refusal(tool::read_obj, kVertices + "f 1 2 +3\n") == "");
}

TEST_CASE("OFF: polygons of any number of corners, at vertices that are there") {
  const std::string before =
      "OFF\n10 1 0\n0 0 0\n4 0 0\n5 1 0\n5 2 0\n4 3 0\n3 4 0\n2 5 0\n1 5 0\n0 4 0\n-1 3 0\n";
  const auto file = tool::read_off(before + "10 0 1 2 3 4 5 6 7 8 9\n", "file");
  CHECK(file.mesh.triangles.size() == 8);
  for (const auto& [polygon, said] : kBadOffs) {
    CHECK(refusal(tool::read_off, before + polygon + "\n") == "file:13" + said);
  }
}
