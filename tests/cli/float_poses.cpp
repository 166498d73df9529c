// cli_float_poses CELL: reads poses as `collide --poses` does, and prints the translation of the
// firmware's pose_of(): x, y and z in cells, one line per pose.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "flashbvh/float.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  const float per_unit = static_cast<float>(1 / std::strtod(argv[1], nullptr));
  float m[12];
  for (int i = 0; std::cin >> m[i];) {
    if (++i < 12) {
      continue;
    }
    i = 0;
    const flashbvh::Pose pose =
        flashbvh::pose_of({{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}},
                          {m[9], m[10], m[11]}, per_unit);
    std::cout << pose.translation(0) << " " << pose.translation(1) << " " << pose.translation(2)
              << "\n";
  }
  return EXIT_SUCCESS;
}
