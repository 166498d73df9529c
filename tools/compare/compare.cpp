// compare FOLDER A-B...: measures each library with equal queries on two meshes, whose images lie
// in FOLDER. Prints lines for page.py:
//     time MESHES MOTION CLASS LIBRARY nanoseconds a query
//     pairs MESHES MOTION LIBRARY found by flashbvh, by the library, by one of the two alone
//     heap MESHES MOTION LIBRARY allocations to make it, bytes they hold, allocations of a query
//     image MESHES bytes of both, triangles
//     known QUESTION MESHES LIBRARY queries, wrong answers
//     approximation MESHES MOTION CLASS KIND poses, reported collisions, bytes of A
//     length MESHES MOTION CLASS LIBRARY poses, how many of them have another distance than
//         flashbvh's, the largest difference in cells, and as a part of the distance
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "comparison.hpp"
#include "flashbvh/image.hpp"

namespace compare {
namespace {

/// An image in memory, opened; throws std::runtime_error.
class Image {
 public:
  explicit Image(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    words_.resize((bytes.size() + 3) / 4);
    bytes.copy(reinterpret_cast<char*>(words_.data()), bytes.size());
    if (flashbvh::open_image(words_.data(), bytes.size(), mesh_) != flashbvh::Status::done) {
      throw std::runtime_error(path + ": no 16-bit post-indexed image");
    }
  }
  const flashbvh::Mesh& mesh() const { return mesh_; }
  std::size_t size() const { return 4 * words_.size(); }

 private:
  std::vector<std::uint32_t> words_;
  flashbvh::Mesh mesh_{};
};

/// With more triangles, filling a distance field takes minutes.
constexpr std::uint32_t kFewTriangles = 3000;
/// The triangles of a box. Boxes are used only for queries with known answers.
constexpr std::uint32_t kBox = 12;

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
  std::printf("image %s %zu %zu\n", names.c_str(), a.size() + b.size(),
              std::size_t{a.mesh().triangle_count} + b.mesh().triangle_count);
  query_known_answers(names, a.mesh(), b.mesh());
  if (a.mesh().triangle_count == kBox) {
    return;
  }
  if (a.mesh().triangle_count <= kFewTriangles) {
    compare_approximations(meshes);
  }
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
