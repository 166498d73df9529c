// brute_force POSE A_COUNT: reads triangles as nine integers each, first those of A, then those of
// B. Tests every triangle of A against every one of B, and prints the pairs as `flashbvh collide
// --pairs` does.
#include <cstdlib>
#include <iostream>
#include <vector>

#include "flashbvh/detail/predicates/triangle.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    return EXIT_FAILURE;
  }
  std::vector<flashbvh::Triangle> triangles;
  flashbvh::Triangle triangle{};
  const auto read = [](flashbvh::Point& p) -> bool { return !!(std::cin >> p.x >> p.y >> p.z); };
  while (read(triangle.corner[0]) && read(triangle.corner[1]) && read(triangle.corner[2])) {
    triangles.push_back(triangle);
  }
  const auto count = static_cast<std::size_t>(std::atoll(argv[2]));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = count; j < triangles.size(); ++j) {
      if (flashbvh::detail::triangles_intersect(triangles.at(i), triangles[j])) {
        std::cout << argv[1] << " " << i << " " << j - count << "\n";
      }
    }
  }
  return count == 0 || count >= triangles.size() ? EXIT_FAILURE : EXIT_SUCCESS;
}
