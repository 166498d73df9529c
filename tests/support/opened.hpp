// An image as a mesh with levels, whether it has them or not.
#ifndef FLASHBVH_TESTS_OPENED_HPP
#define FLASHBVH_TESTS_OPENED_HPP

#include <cstddef>
#include <vector>

#include "bake/levels.hpp"

namespace flashbvh::test {

template <class Mesh>
struct Opened {
  Mesh mesh{};
  std::vector<typename Mesh::Index> levels;

  bool open(const void* bytes, std::size_t size) {
    return bake::open_levelled(bytes, size, mesh, levels) == Status::done;
  }
};

}  // namespace flashbvh::test

#endif
