// Measures a mesh's triangles for its check: the longest edge, and whether the surface is closed.
#pragma once

#include <stdint.h>

#include "flashbvh/lattice.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// A surface is closed if each edge runs as often in either direction: then a point's winding
/// number is equal along every ray. The test sums g(u) h(v) - g(v) h(u) over all edges (u, v), with
/// g and h hashes of vertices. The sum is 0 if the surface is closed. Otherwise it is 0 with a
/// chance below 2^-26, short of bad intent. For random hashes the sum is linear in one vertex's g,
/// whose factor is a multiple of 2^k with a chance of 2^-k.
class Surface {
 public:
  /// Adds a triangle with vertices p, q, r, whose indices are u, v, w.
  void add(uint32_t u, uint32_t v, uint32_t w, const Vertex& p, const Vertex& q, const Vertex& r) {
    measure(p, q);
    measure(q, r);
    measure(r, p);
    const Numbers of_u(u);
    const Numbers of_v(v);
    const Numbers of_w(w);
    sum_ += of_u.g * (of_v.h - of_w.h) + of_v.g * (of_w.h - of_u.h) + of_w.g * (of_u.h - of_v.h);
  }

  bool is_closed() const { return sum_ == 0; }

  /// The longest edge in cells, rounded up; at most 2 * kMaxCoordinate * sqrt(3).
  uint32_t longest_edge() const {
    uint32_t root = 0;
    for (uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {
      const uint32_t more = root + bit;
      root = more * more < longest_squared_ ? more : root;
    }
    return longest_squared_ == 0 ? 0 : root + 1;
  }

 private:
  /// Two hashes of a vertex's index.
  struct Numbers {
    uint32_t g;
    uint32_t h;

    explicit Numbers(uint32_t vertex) {
      g = (vertex + 1) * 0x9E3779B1u;
      g = (g ^ g >> 15) * 0x85EBCA6Bu;
      h = (g ^ g >> 13) * 0xC2B2AE35u;
      g ^= g >> 16;
      h ^= h >> 16;
    }
  };

  void measure(const Vertex& p, const Vertex& q) {
    const uint32_t squared = square(p.x - q.x) + square(p.y - q.y) + square(p.z - q.z);
    longest_squared_ = squared > longest_squared_ ? squared : longest_squared_;
  }

  /// Three squares add up to less than 2^32: 3 * (2 * kMaxCoordinate)^2.
  static uint32_t square(int32_t difference) {
    return static_cast<uint32_t>(difference) * static_cast<uint32_t>(difference);
  }

  uint32_t sum_ = 0;
  uint32_t longest_squared_ = 0;
};

}  // namespace flashbvh::detail
