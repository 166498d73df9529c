// Text files: the nearest double in every format, and refusals of malformed files with the place.
#include "mesh/any_format.hpp"
#include "support/test.hpp"

using tool::FileMesh;
using Names = std::vector<std::string>;

namespace {

/// Compares bits, including the sign of zero. The C library's conversion is independent, and rounds
/// to nearest.
bool reads_as(const TextFormat& format, const std::string& word, double wanted) {
  const std::string text = format.before + "  " + word + "\t1 2\n" + format.after;
  const double found = format.read(text, "file").mesh.vertices.at(0)[0];
  return std::memcmp(&found, &wanted, sizeof found) == 0;
}

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kFix = "; export the mesh again";

const std::string kPly = kPlyHeader + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// `said`: the message between "file" and the advice to export the mesh again.
struct BadPly {
  std::string what;
  std::string by;
  std::string said;
};

const std::string kList = "uchar int vertex_indices";
const std::string kNoList = ": has faces without one list of integers 'vertex_indices'";

const BadPly kBadPlies[] = {
    // The format must be complete and unambiguous.
    {"double x", "double w", ": has vertices without a number 'x'"},
    {"double x", "list uchar int x", ": has vertices without a number 'x'"},
    {"element face 1", "element vertex 1\nproperty float x\nelement face 1",
     ":7: a second element 'vertex'"},
    {"double z", "double y", ":6: a second property 'y'"},
    {"vertex_indices", "corners", kNoList},
    {kList, "float int vertex_indices", ":8: a list whose length is no integer"},
    {"format ascii 1.0\n", "", ":8: the header ends without a 'format'"},
    {"element face 1\nproperty list " + kList + "\n", "",
     ": has no polygons ('vertex' and 'face')"},
    // Each number must fit its type.
    {"3 0 1 2", "3 0 1.5 2", ": face 0 of 1: '1.5' is no int"},
    {"3 0 1 2", "3.0 0 1 2", ": face 0 of 1: '3.0' is no uchar"},
    {"3 0 1 2", "3 0 1 -1", ": face 0 of 1: a corner at vertex -1 of 3"},
    {"3 0 1 2", "3 0 1 18446744073709551616", ": face 0 of 1: '18446744073709551616' is no int"},
    {"3 0 1 2", "2 0 1", ": face 0 of 1: a polygon of 2 corners"},
    {"1 0 0", "1 nan 0", ": vertex 1 of 3: 'nan' is no finite double"},
    {"3 0 1 2\n", "3 0 1 2\n7\n", ": has more than its header announces"},
};

std::string facet(int z) {
  const std::string height = " " + std::to_string(z) + "\n";
  return "facet normal 0 0 1\nouter loop\nvertex 0 0" + height + "vertex 1 0" + height +
         "vertex 0 1" + height + "endloop\nendfacet\n";
}

}  // namespace

TEST_CASE("a number of a text is the nearest double, in every format") {
  const std::vector<std::string> words = {
      "0.1", "-0", "0", ".5", "5.", "+.5", "-.5", "1e3", "1E+3", "5.e-1", "0.3", "1000000.03",
      "5000000.3", "0.1000000000000000055511151231257827", "123456789012345678901234567890",
      "18446744073709551616", "18446744073709551617", "36893488147419103232",
      "00000000000000000000000000000000000001.5",
      // Halfway between two doubles, and slightly to either side.
      "9007199254740993", "9007199254740995", "9007199254740992.99999999999999999999",
      "9007199254740993.00000000000000000001", "1.00000000000000011102230246251565404",
      "1.00000000000000011102230246251565405", "1.00000000000000011102230246251565403",
      // Subnormal, below half of the least one, too small for any, as large as a float.
      "4.9e-324", "1e-310", "2.2250738585072011e-308", "2.5e-324", "2.4e-324", "1e-400", "-1e-999",
      "3.4028234663852886e38", "-340282346638528859811704183484516925440"};
  for (const TextFormat& format : kTextFormats) {
    for (const std::string& word : words) {
      CAPTURE(format.name, word);
      CHECK(reads_as(format, word, std::strtod(word.c_str(), nullptr)));
    }
  }
}

TEST_CASE("what is no number, or none that a float can hold, is no coordinate in any format") {
  const std::vector<std::string> words = {
      "nan",   "-nan", "inf",  "INF", "infinity", "0x10",  "0x1p3", "1e39", "-1e39",   "3.5e38",
      "1e999", "1,5",  "1.5f", "1d3", "--1",      "+-1",   "-+1",   "++1",  "+",       "-",
      ".",     "e5",   "1e",   "1e+", "1.2.3",    "1_000", "1/2",   "x",    "\xD9\xA1"};
  for (const TextFormat& format : kTextFormats) {
    for (const std::string& word : words) {
      CAPTURE(format.name, word);
      CHECK(refusal(format.read, format.before + word + " 1 2\n" + format.after) != "");
    }
  }
}

TEST_CASE("line ends, blanks and comments change nothing") {
  for (const TextFormat& format : kTextFormats) {
    CAPTURE(format.name);
    const std::string plain = format.before + "0.1 0.2 0.3\n" + format.after;
    const FileMesh wanted = format.read(plain, "file");
    for (const std::string end : {"\r\n", "\r", " \t\n"}) {
      std::string changed;
      for (const char c : plain) {
        changed += c == '\n' ? end : c == ' ' ? "\t " : std::string(1, c);
      }
      const FileMesh found = format.read(changed, "file");
      CHECK(found.mesh.vertices == wanted.mesh.vertices);
      CHECK(found.mesh.triangles == wanted.mesh.triangles);
    }
  }
  const std::string comments = "# a\n\nv 0.1 0 0 # b\n#v 9 9 9\n\nv 1 0 0\nv 0 1 0\nf 1 2 3#\n";
  CHECK(tool::read_obj(comments, "file").mesh.vertices.size() == 3);
}

TEST_CASE("byte order marks before a text, blank lines, NULs and Ctrl-Z behind it change nothing") {
  const std::string pad(3, '\0');
  for (const TextFormat& format : kTextFormats) {
    CAPTURE(format.name);
    const std::string plain = format.before + "0.1 0.2 0.3\n" + format.after;
    for (const std::string& changed :
         {"\xEF\xBB\xBF" + plain, plain + "\n \n", plain + pad, plain + "\x1A"}) {
      CHECK(format.read(changed, "file").mesh.triangles.size() == 1);
    }
  }
  for (const std::string before : {"\r\n\n", "  ", "# made by a tool\n", "\xEF\xBB\xBF\n#\n"}) {
    CHECK(tool::read_stl(before + "solid\n" + facet(0) + "# a comment\nendsolid\n", "file")
              .mesh.triangles.size() == 1);
  }
}

TEST_CASE("a file of other contents than its name says is refused by what it holds") {
  struct Case {
    std::string bytes;
    const char* said;
  };
  const Case cases[] = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 123\n", "Git LFS"},
      {"\x1F\x8B\x08" + std::string(97, '\0'), "gzip"},
      {"PK\x03\x04" + std::string(96, 'x'), "zip"},
      {"\xFF\xFEs" + std::string(1, '\0') + "o", "UTF-16"},
      {"glTF" + std::string(96, '\2'), "GLB"},
      {"<!DOCTYPE html>\n<html>", "a page of the web"},
      {"<?xml version=\"1.0\"?>\n<COLLADA/>", "is XML"},
  };
  for (const auto read : {tool::read_stl, tool::read_obj, tool::read_ply}) {
    for (const auto& [bytes, said] : cases) {
      CAPTURE(said);
      CHECK(refusal(read, bytes).find(said) != std::string::npos);
    }
  }
}

TEST_CASE(
    "a text that is no ASCII STL is refused at its first wrong word, whatever its letters count") {
  const std::string words =
      "a text in words only, long enough for a header of eighty bytes, a count of them, and more\n";
  CHECK(refusal(tool::read_stl, words) == "file:1: 'a' is where 'solid' must be" + kFix);
  CHECK(refusal(tool::read_stl, "ply\n" + words) ==
        "file:1: 'ply' is where 'solid' must be" + kFix);
  CHECK(refusal(tool::read_stl, "solid\n" + facet(0) + "endsolid\n" + words) ==
        "file:10: 'a' is where 'solid' must be" + kFix);
  // No triangle is taken for a part of a name.
  std::string line = facet(0);
  std::replace(line.begin(), line.end(), '\n', ' ');
  for (const std::string& text : {"solid a " + line + "\n" + facet(1) + "endsolid\n",
                                  "solid\n" + facet(0) + "endsolid solid " + line + "endsolid\n"}) {
    CHECK(refusal(tool::read_stl, text).find("a triangle on the line of a solid's name") !=
          std::string::npos);
  }
}

TEST_CASE("a text that is cut anywhere is refused, or read with a warning at its last number") {
  for (const TextFormat& format : kTextFormats) {
    const std::string whole = format.before + "1 2 3\n" + format.after;
    CHECK(format.read(whole, "file").warnings.empty());
    const std::size_t last = whole.find_last_of("0123456789");
    for (std::size_t size = 1; size < (format.read == tool::read_stl ? whole.size() - 8 : last);
         ++size) {
      CAPTURE(format.name, size);
      CHECK(refusal(format.read, whole.substr(0, size)) != "");
    }
  }
  CHECK(tool::read_obj(kVertices + "f 1 2 3", "file").warnings ==
        Names{"the last line has no end: the file may be truncated"});
}

TEST_CASE("OBJ: points and lines are left out, which is said") {
  CHECK(tool::read_obj(kVertices + "l 1 2\np 1\nf 1 2 3\n", "file").warnings ==
        Names{"2 points or lines left out"});
}

TEST_CASE("OBJ: a line that adds what another file holds is refused") {
  for (const std::string line : {"call part.obj", "csh make_part"}) {
    CHECK(refusal(tool::read_obj, kVertices + line + "\nf 1 2 3\n").find("file:4: '") == 0);
  }
}

TEST_CASE("PLY: what is malformed") {
  CHECK(refusal(tool::read_ply, kPly) == "");
  CHECK(refusal(tool::read_ply, with(kPly, "double x", "int x")) == "");
  for (const auto& [what, by, said] : kBadPlies) {
    CAPTURE(what, by);
    CHECK(refusal(tool::read_ply, with(kPly, what, by)) == "file" + said + kFix);
  }
  CHECK(refusal(tool::read_ply, with(with(kPly, "double x", "int x"), "1 0 0", "1.5 0 0")) ==
        "file: vertex 1 of 3: '1.5' is no int" + kFix);
  CHECK(refusal(tool::read_ply, with(kPly, "element face 1",
                                     "element tristrips 2\nproperty list int int vertex_indices\n"
                                     "element face 1")) ==
        "file: has triangle strips ('tristrips'); export the mesh as polygons");
}

TEST_CASE("OBJ: weights of 1, colours, normals and materials change nothing") {
  const FileMesh file = tool::read_obj(
      "mtllib missing.mtl\nv 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nvn 0 0 1\nusemtl red\n"
      "  f 1//1 2//1 3//1\ng two\nf 1/1/1 3/1 2\n",
      "file");
  CHECK(file.mesh.vertices.size() == 3);
  CHECK(file.mesh.triangles.size() == 2);
}

TEST_CASE("OBJ: a corner is an integer") {
  for (const std::string corner : {".5", "1.0", "1.", "0", "4", "-4", "18446744073709551617", "1e0",
                                   "+", "x", "/1", "9223372036854775807", "-9223372036854775808"}) {
    CHECK(refusal(tool::read_obj, kVertices + "f 1 2 " + corner + "\n") ==
          "file:4: a corner at vertex '" + corner + "', but there are 3 vertices so far" + kFix);
  }
  CHECK(refusal(tool::read_obj, kVertices + "f 1 2 +3\n") == "");
}

TEST_CASE("all solids of a text are one mesh, whatever their names hold") {
  const FileMesh file =
      tool::read_stl("solid facet Vertex \n" + facet(0) + facet(1) +
                         "endsolid facet Vertex\nsolid empty\nendsolid\nSOLID\n" + facet(0) +
                         "ENDSOLID\nsolid a\n" + facet(2) + "endsolid b\n",
                     "file");
  CHECK(file.mesh.triangles.size() == 4);
  CHECK(file.mesh.vertices.size() == 9);
  const std::string objects =
      "o wheel \\\n left\n" + kVertices + "g a\nf 1 2 3#4\no wheel#1\nf 3 2 1\n";
  CHECK(tool::read_obj(objects, "file").mesh.triangles.size() == 2);
}
