#include "meshes.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace compare {

Image::Image(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  words_.resize((bytes.size() + 3) / 4);
  bytes.copy(reinterpret_cast<char*>(words_.data()), bytes.size());
  if (flashbvh::open_image(words_.data(), bytes.size(), mesh_) != flashbvh::Status::done) {
    throw std::runtime_error(path + ": no 16-bit post-indexed image");
  }
}

}  // namespace compare
