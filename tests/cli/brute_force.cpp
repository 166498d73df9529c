// brute_force POSE A.obj B.obj: tests every triangle of A against every one of B, both as exported
// (B transformed), and prints the pairs as `flashbvh collide --pairs` does.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "flashbvh/detail/predicates/triangle.hpp"

namespace {

std::vector<flashbvh::Triangle> read(const char* path) {
  std::ifstream file(path);
  std::vector<flashbvh::Point> vertices;
  std::vector<flashbvh::Triangle> triangles;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      flashbvh::Point p{};
      words >> p.x >> p.y >> p.z;
      vertices.push_back(p);
    } else if (keyword == "f") {
      flashbvh::Triangle triangle{};
      for (flashbvh::Point& corner : triangle.corner) {
        std::size_t number = 0;
        words >> number;
        corner = vertices.at(number - 1);
      }
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    return EXIT_FAILURE;
  }
  const auto a = read(argv[2]);
  const auto b = read(argv[3]);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (flashbvh::detail::triangles_intersect(a[i], b[j])) {
        std::printf("%s %zu %zu\n", argv[1], i, j);
      }
    }
  }
  return a.empty() || b.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
