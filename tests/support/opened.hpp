// Opens an image as a mesh with levels, even if it has none.
#pragma once

#include <cstddef>
#include <vector>

#include "bake/made_levels.hpp"

namespace flashbvh::test {

template <class Mesh>
struct Opened {
  Mesh mesh{};
  std::vector<typename Mesh::Index> levels;

  bool open(const void* bytes, std::size_t size) {
    return open_levelled(bytes, size, mesh, levels) == Status::done;
  }
};

}  // namespace flashbvh::test
