// What the check of a mesh learns of its triangles: the longest edge, and whether the surface is
// closed.
#ifndef FLASHBVH_IMAGE_SURFACE_HPP
#define FLASHBVH_IMAGE_SURFACE_HPP

#include <stdint.h>

#include "flashbvh/detail/inline.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::detail {

/// A surface is closed if each edge is run through as often one way as the other: then a point's
/// winding number is the same along every ray. Told by a sum over all edges, of a number that the
/// two vertices make, positive one way, negative the other: 0 if it is closed, and otherwise, short
/// of bad intent, by a chance of 2^-64.
class Surface {
 public:
  /// A triangle, by its vertices' indices.
  FLASHBVH_NOINLINE void add(uint32_t u, uint32_t v, uint32_t w, const Vertex* vertices) {
    add_edge(u, v, vertices);
    add_edge(v, w, vertices);
    add_edge(w, u, vertices);
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
  void add_edge(uint32_t u, uint32_t v, const Vertex* vertices) {
    const Vertex& p = vertices[u];
    const Vertex& q = vertices[v];
    const uint32_t squared = square(p.x - q.x) + square(p.y - q.y) + square(p.z - q.z);
    longest_squared_ = squared > longest_squared_ ? squared : longest_squared_;
    if (u < v) {
      sum_ += number_of(u, v);
    } else if (v < u) {
      sum_ -= number_of(v, u);
    }
  }

  /// Three of them stay below 2^32: 3 * (2 * kMaxCoordinate)^2.
  static uint32_t square(int32_t difference) {
    return static_cast<uint32_t>(difference) * static_cast<uint32_t>(difference);
  }

  /// Two vertices to one of 2^64 numbers, each to another one: multiplied by odd numbers, the high
  /// word mixed into the low one between.
  static uint64_t number_of(uint32_t u, uint32_t v) {
    const uint64_t spread = (uint64_t{u} << 32 | v) * 0xBF58476D1CE4E5B9u;
    return (spread ^ spread >> 32) * 0x94D049BB133111EBu;
  }

  uint64_t sum_ = 0;
  uint32_t longest_squared_ = 0;
};

}  // namespace flashbvh::detail

#endif
