// make_meshes FOLDER [large]: writes the meshes that the tests of the command line work on, or the
// one large one, to the folder.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

using Point = std::array<float, 3>;
using Triangle = std::array<Point, 3>;

Point on_torus(int i, int j, int rings, int sides) {
  const double u = 2 * 3.14159265358979323846 * (i % rings) / rings;
  const double v = 2 * 3.14159265358979323846 * (j % sides) / sides;
  const double r = 20 + 6 * std::cos(v);
  return {static_cast<float>(r * std::cos(u)), static_cast<float>(r * std::sin(u)),
          static_cast<float>(6 * std::sin(v))};
}

std::vector<Triangle> torus(int rings, int sides) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const Point p = on_torus(i, j, rings, sides);
      const Point q = on_torus(i + 1, j, rings, sides);
      const Point r = on_torus(i + 1, j + 1, rings, sides);
      const Point s = on_torus(i, j + 1, rings, sides);
      triangles.push_back({p, q, r});
      triangles.push_back({p, r, s});
    }
  }
  return triangles;
}

void write_stl(const std::string& path, const std::vector<Triangle>& triangles) {
  std::ofstream file(path, std::ios::binary);
  file << std::string(80, 's').replace(0, 5, "solid");  // as some programs write it
  const auto count = static_cast<std::uint32_t>(triangles.size());
  file.write(reinterpret_cast<const char*>(&count), 4);
  for (const Triangle& triangle : triangles) {
    file << std::string(12, '\0');
    file.write(reinterpret_cast<const char*>(&triangle), 36);
    file << std::string(2, '\0');
  }
}

/// Loose triangles, with three vertices each of their own.
std::vector<Triangle> loose(int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const int row = i / 200;
    const auto x = static_cast<float>(i % 200);
    const auto y = static_cast<float>(row);
    triangles.push_back({Point{x, y, 0}, Point{x + 0.5f, y, 0}, Point{x, y + 0.5f, 0}});
  }
  return triangles;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    return EXIT_FAILURE;
  }
  const std::string folder = std::string(argv[1]) + "/";
  std::filesystem::create_directories(folder);
  if (argc > 2) {
    write_stl(folder + "large.stl", torus(400, 250));
    return EXIT_SUCCESS;
  }
  write_stl(folder + "ring.stl", torus(20, 10));
  write_stl(folder + "coarse.stl", torus(8, 5));
  const std::vector<Triangle> tetrahedron = {{Point{0, 0, 0}, Point{0, 10, 0}, Point{10, 0, 0}},
                                             {Point{0, 0, 0}, Point{0, 0, 10}, Point{0, 10, 0}},
                                             {Point{0, 0, 0}, Point{10, 0, 0}, Point{0, 0, 10}},
                                             {Point{10, 0, 0}, Point{0, 10, 0}, Point{0, 0, 10}}};
  write_stl(folder + "tetrahedron.stl", tetrahedron);
  std::vector<Triangle> broken = tetrahedron;
  broken[2][1][0] = std::numeric_limits<float>::quiet_NaN();
  write_stl(folder + "nan.stl", broken);
  broken[2][1][0] = std::numeric_limits<float>::infinity();
  write_stl(folder + "infinite.stl", broken);
  write_stl(folder + "no_triangles.stl", {});
  write_stl(folder + "many_nodes.stl", torus(200, 100));
  write_stl(folder + "many_vertices.stl", loose(22000));
  write_stl(folder + "many_triangles.stl", torus(200, 165));
  return EXIT_SUCCESS;
}
