// What the check of a mesh learns of its triangles: the longest edge, and whether the surface is
// closed.
#ifndef FLASHBVH_LATTICE_SURFACE_HPP
#define FLASHBVH_LATTICE_SURFACE_HPP

#include <stdint.h>

#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// A surface is closed if each edge is run through as often one way as the other: then a point's
/// winding number is the same along every ray. Decided by a sum over all edges (u, v) of
/// g(u) h(v) - g(v) h(u), where g and h make numbers of vertices that look random: 0 if it is
/// closed, and otherwise, short of bad intent, by a chance below 2^-26: of numbers that are random
/// the sum is linear in one vertex's g, whose factor is a multiple of 2^k by a chance of 2^-k.
class Surface {
 public:
  /// A triangle: the vertices p, q and r, and their indices.
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

  /// In cells, rounded up: at most 2 * kMaxCoordinate * sqrt(3).
  uint32_t longest_edge() const {
    uint32_t root = 0;
    for (uint32_t bit = 1u << 15; bit != 0; bit >>= 1) {
      const uint32_t more = root + bit;
      root = more * more < longest_squared_ ? more : root;
    }
    return longest_squared_ == 0 ? 0 : root + 1;
  }

 private:
  /// Of a vertex.
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

  /// Three of them stay below 2^32: 3 * (2 * kMaxCoordinate)^2.
  static uint32_t square(int32_t difference) {
    return static_cast<uint32_t>(difference) * static_cast<uint32_t>(difference);
  }

  uint32_t sum_ = 0;
  uint32_t longest_squared_ = 0;
};

}  // namespace flashbvh::detail

#endif
