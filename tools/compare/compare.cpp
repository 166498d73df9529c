// compare FOLDER A-B...: what each library takes for the same queries on two meshes, whose images
// lie in FOLDER. Prints lines for table.awk:
//     time MESHES MOTION CLASS LIBRARY nanoseconds a query
//     pairs MESHES MOTION LIBRARY found by flashbvh, by the library, by one of the two alone
//     length MESHES MOTION CLASS LIBRARY poses, how many of them have another distance than
//         flashbvh's, the largest difference in cells, and as a part of the distance
#include <cstdio>
#include <exception>
#include <string>

#include "comparison.hpp"
#include "meshes.hpp"

namespace compare {
namespace {

void compare_pair(const std::string& folder, const std::string& names) {
  const std::size_t dash = names.find('-');
  const std::string file_a = "/" + names.substr(0, dash) + ".fbvh";
  const std::string file_b = "/" + names.substr(dash + 1) + ".fbvh";
  const Image a(folder + file_a);
  const Image b(folder + file_b);
  const Image searched_a(folder + "/searched" + file_a);
  const Image searched_b(folder + "/searched" + file_b);
  const PairOfMeshes meshes = {
      names, {&searched_a.mesh(), &searched_b.mesh()}, {&a.mesh(), &b.mesh()}};
  for (const bool rotated : {false, true}) {
    compare_collisions(meshes, rotated);
    compare_distances(meshes, rotated);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace compare

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: compare FOLDER A-B...\n", stderr);
    return 2;
  }
  try {
    for (int i = 2; i < argc; ++i) {
      compare::compare_pair(argv[1], argv[i]);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 1;
  }
  return 0;
}
