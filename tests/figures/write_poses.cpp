// write_poses FOLDER SEARCHED PAIR...: FOLDER/poses.cpp, the poses that the figures are taken at.
//
// PAIR: two meshes' names, as bicep-palm, whose images lie in FOLDER, and in SEARCHED with one
// triangle a leaf. The same file every time: the poses follow from the latter alone, what a query
// at each of them counts from the former.
#include <cstdint>
#include <cstdio>
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

/// An image in memory, opened.
class Image {
 public:
  explicit Image(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    words_.resize((bytes.size() + 3) / 4);
    bytes.copy(reinterpret_cast<char*>(words_.data()), bytes.size());
    is_open_ = open_image(words_.data(), bytes.size(), tree_) == Status::done;
  }

  bool is_open() const { return is_open_; }
  const PostMesh& tree() const { return tree_; }

 private:
  std::vector<std::uint32_t> words_;
  PostMesh tree_{};
  bool is_open_ = false;
};

class ImagePair {
 public:
  ImagePair(const std::string& folder, const std::string& a, const std::string& b)
      : a_(folder + "/" + a + ".fbvh"), b_(folder + "/" + b + ".fbvh") {
    if (!is_open()) {
      std::fprintf(stderr, "write_poses: no 16-bit post-indexed images of %s and %s in %s\n",
                   a.c_str(), b.c_str(), folder.c_str());
    }
  }

  bool is_open() const { return a_.is_open() && b_.is_open(); }
  Meshes meshes() const { return {&a_.tree(), &b_.tree()}; }

 private:
  Image a_;
  Image b_;
};

struct Folders {
  std::string asked;
  std::string searched;
};

void write_asked(std::ostream& out, const Asked& asked) {
  const auto& q = asked.quaternion;
  out << "          {{" << q[0] << ", " << q[1] << ", " << q[2] << ", " << q[3] << "}, {"
      << asked.cells[0] << ", " << asked.cells[1] << ", " << asked.cells[2] << "}, " << asked.visits
      << ", " << asked.leaf_pairs << ", " << asked.triangle_pairs << ", " << asked.work << "},\n";
}

void write_motion(std::ostream& out, PoseSearch& search, bool rotated) {
  out << "     {\n";
  for (std::uint32_t proximity = 0; proximity < kProximities; ++proximity) {
    out << "         {\n";
    for (std::uint32_t i = 0; i < kPosesOfPair; ++i) {
      write_asked(out, search.next(static_cast<Proximity>(proximity), rotated));
    }
    out << "         },\n";
  }
  out << "     },\n";
}

/// False, with a message, if an image can't be opened.
bool write_pair(std::ostream& out, const Folders& folders, const std::string& a,
                const std::string& b) {
  const ImagePair asked(folders.asked, a, b);
  const ImagePair searched(folders.searched, a, b);
  if (!asked.is_open() || !searched.is_open()) {
    return false;
  }
  PoseSearch search(searched.meshes(), asked.meshes(), kSeed);
  out << "    {\"" << a << "\", \"" << b << "\", &" << a << "::mesh, &" << b << "::mesh,\n";
  write_motion(out, search, false);
  write_motion(out, search, true);
  out << "    },\n";
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: write_poses FOLDER SEARCHED PAIR...\n", stderr);
    return 2;
  }
  const Folders folders = {argv[1], argv[2]};
  std::ofstream out(folders.asked + "/poses.cpp");
  out << "// Written by write_poses.\n#include \"asked.hpp\"\n";
  std::vector<std::pair<std::string, std::string>> pairs;
  std::set<std::string> meshes;
  for (int i = 3; i < argc; ++i) {
    const std::string names = argv[i];
    const std::size_t dash = names.find('-');
    pairs.emplace_back(names.substr(0, dash), names.substr(dash + 1));
    meshes.insert({pairs.back().first, pairs.back().second});
  }
  for (const std::string& mesh : meshes) {
    out << "#include \"" << mesh << ".fbvh.hpp\"\n";
  }
  out << "\nnamespace figures {\n\nconst AskedPair kAskedPairs[] = {\n";
  for (const auto& [a, b] : pairs) {
    if (!write_pair(out, folders, a, b)) {
      return 1;
    }
  }
  out << "};\nconst uint32_t kAskedPairCount = " << pairs.size()
      << ";\n\n}  // namespace figures\n";
  return out.flush() ? 0 : 1;
}
