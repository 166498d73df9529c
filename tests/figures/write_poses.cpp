// write_poses FOLDER SEARCHED PAIR...: writes FOLDER/poses.cpp, the poses of the figures.
//
// PAIR: two meshes' names, as bicep-palm, whose images lie in FOLDER, and with one triangle per
// leaf in SEARCHED. The file is equal each time: the poses depend on SEARCHED alone, their counts
// on FOLDER.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "flashbvh/image.hpp"
#include "pose_search.hpp"

using namespace flashbvh;
using namespace figures;

namespace {

constexpr std::uint64_t kSeed = 20240607;

/// An opened image in memory. Ends the program with a message if it cannot be opened.
class Image {
 public:
  Image(const std::string& folder, const std::string& mesh) {
    const std::string path = folder + "/" + mesh + ".fbvh";
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    words_.resize((bytes.size() + 3) / 4);
    bytes.copy(reinterpret_cast<char*>(words_.data()), bytes.size());
    if (open_image(words_.data(), bytes.size(), tree_) != Status::done) {
      std::fprintf(stderr, "write_poses: no 16-bit post-indexed image: %s\n", path.c_str());
      std::exit(1);
    }
  }
  const Mesh* tree() const { return &tree_; }

 private:
  std::vector<std::uint32_t> words_;
  Mesh tree_{};
};

void write_pose(std::ostream& out, const QueryPose& query_pose) {
  const auto& q = query_pose.quaternion;
  out << "          {{" << q[0] << ", " << q[1] << ", " << q[2] << ", " << q[3] << "}, {"
      << query_pose.cells[0] << ", " << query_pose.cells[1] << ", " << query_pose.cells[2] << "}, "
      << query_pose.visits << ", " << query_pose.leaf_pairs << ", " << query_pose.triangle_pairs
      << ", " << query_pose.work << "},\n";
}

void write_motion(std::ostream& out, PoseSearch& search, bool rotated) {
  out << "     {\n";
  for (std::uint32_t proximity = 0; proximity < kProximities; ++proximity) {
    out << "         {\n";
    for (std::uint32_t i = 0; i < kPosesOfPair; ++i) {
      write_pose(out, search.next(static_cast<Proximity>(proximity), rotated));
    }
    out << "         },\n";
  }
  out << "     },\n";
}

void write_pair(std::ostream& out, const char* const* folders, const std::string& a,
                const std::string& b) {
  const Image queried_a(folders[0], a);
  const Image queried_b(folders[0], b);
  const Image searched_a(folders[1], a);
  const Image searched_b(folders[1], b);
  PoseSearch search({searched_a.tree(), searched_b.tree()}, {queried_a.tree(), queried_b.tree()},
                    kSeed);
  out << "    {\"" << a << "\", \"" << b << "\", &" << a << ", &" << b << ",\n";
  write_motion(out, search, false);
  write_motion(out, search, true);
  out << "    },\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: write_poses FOLDER SEARCHED PAIR...\n", stderr);
    return 2;
  }
  std::ofstream out(std::string(argv[1]) + "/poses.cpp");
  out << "// Written by write_poses.\n#include \"query_pose.hpp\"\n";
  std::vector<std::pair<std::string, std::string>> pairs;
  std::set<std::string> meshes;
  for (int i = 3; i < argc; ++i) {
    const std::string names = argv[i];
    const std::size_t dash = names.find('-');
    pairs.emplace_back(names.substr(0, dash), names.substr(dash + 1));
    meshes.insert({pairs.back().first, pairs.back().second});
  }
  for (const std::string& mesh : meshes) {
    out << "#include \"" << mesh << ".fbvh.h\"\n";
  }
  out << "#include \"flashbvh/image.hpp\"\n\nnamespace figures {\n\n";
  for (const std::string& mesh : meshes) {
    out << "const auto " << mesh << " = flashbvh::view_unchecked<flashbvh::Mesh>(" << mesh
        << "_image);\n";
  }
  out << "\nconst MeshPair kMeshPairs[] = {\n";
  for (const auto& [a, b] : pairs) {
    write_pair(out, argv + 1, a, b);
  }
  out << "};\nconst uint32_t kMeshPairCount = " << pairs.size() << ";\n\n}  // namespace figures\n";
  return out.flush() ? 0 : 1;
}
