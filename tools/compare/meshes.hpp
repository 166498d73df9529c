// Baked meshes as flashbvh has them, and the same in floats for the others.
#ifndef FLASHBVH_TOOLS_COMPARE_MESHES_HPP
#define FLASHBVH_TOOLS_COMPARE_MESHES_HPP

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "flashbvh/image.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"

namespace compare {

/// The unit of the other libraries' meshes: a power of two, so that every vertex is exact in
/// binary32, and of a size that keeps their products of five lengths and areas far from its limits.
constexpr double kCellsOfUnit = 1024;

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
  const flashbvh::PostMesh& mesh() const { return mesh_; }
  std::size_t size() const { return 4 * words_.size(); }

 private:
  std::vector<std::uint32_t> words_;
  flashbvh::PostMesh mesh_{};
};

/// A vertex in the mesh's frame, in units.
template <class Number>
void set_vertex(const flashbvh::PostMesh& mesh, std::uint32_t vertex, Number (&point)[3]) {
  const flashbvh::Vertex& v = mesh.vertices[vertex];
  const std::int32_t cells[3] = {v.x, v.y, v.z};
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = static_cast<Number>((mesh.origin[axis] + cells[axis]) / kCellsOfUnit);
  }
}

inline double rotation_of(const flashbvh::Pose& pose, int row, int column) {
  return pose.rotation(row, column) / static_cast<double>(flashbvh::kRotationOne);
}

/// In units.
inline double translation_of(const flashbvh::Pose& pose, int axis) {
  return (pose.translation(axis) + pose.fraction(axis) / 65536.0) / kCellsOfUnit;
}

}  // namespace compare

#endif
