// Binary files: unchanged numbers of each type, in both byte orders.
#include <filesystem>
#include <fstream>

#include "mesh/any_format.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

std::string binary_stl(const std::vector<float>& coordinates) {
  std::string bytes(80, ' ');
  bytes += bytes_of(static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    bytes += i % 9 == 0 ? std::string(12, '\xFF') : "";
    bytes += bytes_of(coordinates[i]);
    bytes += i % 9 == 8 ? "ab" : "";
  }
  return bytes;
}

/// A triangle whose first vertex has these coordinates, of this type.
template <class Number>
std::string binary_ply(const std::string& type, const std::array<Number, 3>& first, bool big) {
  std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 3\nproperty uchar red\n";
  for (const char* axis : {"x", "y", "z"}) {
    bytes += "property " + type + " " + axis + "\n";
  }
  bytes +=
      "property list ushort short other\nelement face 1\nproperty float quality\n"
      "property list uint ushort vertex_index\nend_header\n";
  const std::array<std::array<Number, 3>, 3> vertices = {
      first, {Number{100}, Number{1}, Number{2}}, {Number{3}, Number{100}, Number{4}}};
  for (const auto& vertex : vertices) {
    bytes += "\xFE";
    for (const Number coordinate : vertex) {
      bytes += bytes_of(coordinate, big);
    }
    bytes += bytes_of(std::uint16_t{1}, big) + bytes_of(std::int16_t{-1}, big);
  }
  bytes += bytes_of(std::numeric_limits<float>::quiet_NaN(), big);
  bytes += bytes_of(std::uint32_t{3}, big);
  for (std::uint16_t corner = 0; corner < 3; ++corner) {
    bytes += bytes_of(corner, big);
  }
  return bytes;
}

template <class Number>
void check_ply(const std::string& type, const std::array<Number, 3>& first) {
  for (const bool big : {false, true}) {
    CAPTURE(type, big);
    const FileMesh file = tool::read_ply(binary_ply(type, first, big), "file");
    REQUIRE(file.mesh.vertices.size() == 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(file.mesh.vertices[0][axis] == static_cast<double>(first[axis]));
    }
  }
}

template <class Integer>
std::array<Integer, 3> extremes() {
  using Limits = std::numeric_limits<Integer>;
  return {Limits::min(), Limits::max(), Integer{5}};
}

}  // namespace

TEST_CASE("binary STL: each float as it is, to the subnormal ones and the largest") {
  using Limits = std::numeric_limits<float>;
  const std::vector<float> floats = {0.1f,          -0.0f,          Limits::denorm_min(),
                                     Limits::max(), -Limits::max(), Limits::min() / 2,
                                     16777217.0f,   1.0f / 3,       -1e-30f};
  const FileMesh file = tool::read_stl(binary_stl(floats), "file");
  REQUIRE(file.mesh.vertices.size() == 3);
  for (std::size_t i = 0; i < floats.size(); ++i) {
    CHECK(file.mesh.vertices[i / 3][i % 3] == static_cast<double>(floats[i]));
  }
  CHECK(std::signbit(file.mesh.vertices[0][1]));
}

TEST_CASE(
    "binary STL: bytes behind the last triangle are left out with a warning, unless they may be "
    "triangles") {
  const std::string whole = binary_stl({0, 0, 0, 1, 0, 0, 0, 1, 0});
  CHECK(tool::read_stl(whole, "file").warnings.empty());
  for (const std::string& behind :
       {std::string("\n"), std::string(49, 'x'), std::string(428, '\0')}) {
    const FileMesh file = tool::read_stl(whole + behind, "file");
    CHECK(file.mesh.triangles.size() == 1);
    CHECK(file.warnings == std::vector<std::string>{std::to_string(behind.size()) +
                                                    " bytes behind the last triangle left out"});
  }
  CHECK(refusal(tool::read_stl, whole + std::string(50, 'x')) ==
        "file: its header announces 1 triangles, but 50 bytes follow them, which 1 more would "
        "fill; export the mesh again");
  std::string none = whole;
  none.replace(80, 4, 4, '\0');
  CHECK(refusal(tool::read_stl, none).find("announces 0 triangles, but 50 bytes follow") !=
        std::string::npos);
  CHECK(refusal(tool::read_stl, none.substr(0, 84)).find("has no polygons or triangles") !=
        std::string::npos);
  CHECK(refusal(tool::read_stl, whole.substr(0, 133)).find("is truncated") != std::string::npos);
  std::string endless = whole;
  endless.replace(80, 4, 4, 'o');
  endless[90] = 0;
  CHECK(
      refusal(tool::read_stl, std::string(1, '\0') + endless).find("is truncated or no STL file") !=
      std::string::npos);
}

TEST_CASE("binary PLY: each type of number, in both orders of bytes") {
  check_ply("float", std::array<float, 3>{0.1f, std::numeric_limits<float>::denorm_min(), -3e38f});
  check_ply("float64", std::array<double, 3>{0.1, 1000000.03, -5e-324});
  check_ply("char", extremes<std::int8_t>());
  check_ply("uint8", extremes<std::uint8_t>());
  check_ply("short", extremes<std::int16_t>());
  check_ply("uint16", extremes<std::uint16_t>());
  check_ply("int32", extremes<std::int32_t>());
  check_ply("uint", extremes<std::uint32_t>());
}

TEST_CASE("binary PLY: no coordinate is infinite, or larger than a float") {
  for (const double at : {HUGE_VAL, -HUGE_VAL, std::nan(""), 1e39}) {
    const std::string said =
        refusal(tool::read_ply, binary_ply("double", std::array<double, 3>{1, at, 2}, false));
    CHECK(said ==
          "file: vertex 0 of 3: no finite number of at most 3.4e38, which a coordinate "
          "must be; export the mesh again");
  }
}

TEST_CASE("binary PLY, cut off anywhere, is refused") {
  const std::string whole = binary_ply("float", std::array<float, 3>{1, 2, 3}, true);
  for (std::size_t length = 1; length < whole.size(); ++length) {
    CHECK(refusal(tool::read_ply, whole.substr(0, length)) != "");
  }
  CHECK(refusal(tool::read_ply, whole + "\1") ==
        "file: has more than its header announces; export the mesh again");
}

TEST_CASE("what assimp reads of coordinates that are floats is what our own readers read") {
  Random random(test_seed());
  std::vector<float> floats;
  std::string points;
  std::string vertices;
  std::string obj_faces;
  std::string ply_faces;
  for (int i = 0; i < 150; ++i) {
    std::string line;
    for (int axis = 0; axis < 3; ++axis) {
      floats.push_back((static_cast<float>(random.below(4096)) - 2048) / 64);
      line += " " + std::to_string(static_cast<double>(floats.back()));  // six decimals: exact
    }
    vertices += "v" + line + "\n";
    points += line + "\n";
    obj_faces += (i % 3 == 0 ? "f " : " ") + std::to_string(i + 1) + (i % 3 == 2 ? "\n" : "");
    ply_faces += (i % 3 == 0 ? "3 " : " ") + std::to_string(i) + (i % 3 == 2 ? "\n" : "");
  }
  const std::string header = with(with(kPlyHeader, "vertex 3", "vertex 150"), "face 1", "face 50");
  struct Case {
    const char* extension;
    FileMesh (*read)(std::string_view, const std::string&);
    std::string bytes;
  };
  const Case cases[] = {{"stl", tool::read_stl, binary_stl(floats)},
                        {"obj", tool::read_obj, vertices + obj_faces},
                        {"ply", tool::read_ply, header + points + ply_faces}};
  for (const auto& [extension, read, bytes] : cases) {
    CAPTURE(extension);
    const std::string path = std::string("float_exact.") + extension;
    std::ofstream(path, std::ios::binary) << bytes;
    const FileMesh own = read(bytes, path);
    const FileMesh other = tool::read_with_assimp(bytes, path);
    std::filesystem::remove(path);
    CHECK(own.mesh.triangles.size() == 50);
    CHECK(own.mesh.vertices == other.mesh.vertices);
    CHECK(own.mesh.triangles == other.mesh.triangles);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(own.mesh.vertices[0][axis] == static_cast<double>(floats[axis]));
    }
  }
}
