// The paper's tree and its algorithm 2, in binary32: axis-aligned boxes, split top-down along the
// longest axis down to single triangles. A stack traversal descends into the larger volume. Rotated
// boxes are tested along the axes of both frames.
#include <algorithm>
#include <vector>

#include "float_triangles.hpp"
#include "library.hpp"

using flashbvh::Mesh;
using flashbvh::Pose;

namespace compare {
namespace {

struct Node {
  Vec middle;
  Vec half;
  float volume;    ///< negative: a leaf
  uint32_t first;  ///< the first of two adjacent children; in a leaf, the triangle

  bool is_leaf() const { return volume < 0; }
};

/// B's pose in A's frame, as a caller with floats has it.
struct Matrix {
  Vec rows[3];
  Vec translation;
  bool is_rotated;
};

/// The vector of `part(axis)`, in binary32.
template <class Part>
Vec vector_of(const Part& part) {
  return {static_cast<float>(part(0)), static_cast<float>(part(1)), static_cast<float>(part(2))};
}

Matrix matrix_of(const Pose& pose) {
  Matrix matrix{};
  for (int i = 0; i < 3; ++i) {
    matrix.rows[i] = vector_of([&](int column) { return rotation_of(pose, i, column); });
  }
  matrix.translation = vector_of([&](int axis) { return translation_of(pose, axis); });
  matrix.is_rotated = !pose.is_translation();
  return matrix;
}

class Tree {
 public:
  void build(const Mesh& mesh) {
    triangles_.clear();
    const std::vector<Vec> vertices = vertices_of<Vec>(mesh);
    for (uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto& corner = mesh.triangles[i].corner;
      triangles_.push_back(flat_of(vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]));
    }
    nodes_.assign(1, Node());
    fill(0, 0, static_cast<uint32_t>(triangles_.size()));
  }

  const Node* nodes() const { return nodes_.data(); }
  const Flat* triangles() const { return triangles_.data(); }

 private:
  /// Covers rounding errors of rotations; a tenth of the distance between vertices.
  static constexpr float kSlack = 1e-5f;

  void fill(uint32_t at, uint32_t begin, uint32_t end) {
    float Vec::*const axes[] = {&Vec::x, &Vec::y, &Vec::z};
    float Vec::*longest = axes[0];
    Node node{};
    node.volume = 1;
    for (float Vec::*const axis : axes) {
      float low = 1e30f;
      float high = -1e30f;
      for (uint32_t i = begin; i < end; ++i) {
        for (const Vec& v : triangles_[i].corner) {
          low = std::min(low, v.*axis);
          high = std::max(high, v.*axis);
        }
      }
      node.middle.*axis = (low + high) / 2;
      node.half.*axis = std::max(high - node.middle.*axis, node.middle.*axis - low) + kSlack;
      node.volume *= node.half.*axis;
      longest = node.half.*axis > node.half.*longest ? axis : longest;
    }
    const bool is_leaf = end - begin == 1;
    node.volume = is_leaf ? -1 : node.volume;
    node.first = is_leaf ? begin : static_cast<uint32_t>(nodes_.size());
    nodes_[at] = node;
    if (is_leaf) {
      return;
    }
    // Splits at the mean of the triangles' centres, which makes a better tree than their median.
    const auto sum = [longest](const Flat& t) {
      return t.corner[0].*longest + t.corner[1].*longest + t.corner[2].*longest;
    };
    float mean = 0;
    for (uint32_t i = begin; i < end; ++i) {
      mean += sum(triangles_[i]) / static_cast<float>(end - begin);
    }
    const auto from = triangles_.begin();
    const auto at_mean =
        std::partition(from + begin, from + end, [&](const Flat& t) { return sum(t) < mean; });
    const auto found = static_cast<uint32_t>(at_mean - from);
    const uint32_t half = found == begin || found == end ? (begin + end) / 2 : found;
    nodes_.resize(nodes_.size() + 2);
    fill(node.first, begin, half);
    fill(node.first + 1, half, end);
  }

  std::vector<Flat> triangles_;
  std::vector<Node> nodes_;
};

Vec magnitudes(const Vec& v) {
  return {__builtin_fabsf(v.x), __builtin_fabsf(v.y), __builtin_fabsf(v.z)};
}

/// True if boxes with centres `apart` along an axis are separated on it.
bool parts(float apart, float half, float other) {
  return __builtin_fabsf(apart) > half + other;
}

/// A box in the other frame: its centre and its half sizes along the axes.
struct Seen {
  Vec middle;
  Vec half;
};

/// B is translated.
struct Moved {
  Vec t;

  explicit Moved(const Matrix& pose) : t(pose.translation) {}
  Seen seen_of_a(const Node& a) const { return {a.middle - t, a.half}; }
  Seen seen_of_b(const Node& b) const { return {b.middle + t, b.half}; }
  /// Tests a box against another one in its frame.
  static bool overlap(const Node& box, const Seen& other) {
    return !parts(other.middle.x - box.middle.x, box.half.x, other.half.x) &&
           !parts(other.middle.y - box.middle.y, box.half.y, other.half.y) &&
           !parts(other.middle.z - box.middle.z, box.half.z, other.half.z);
  }
  bool overlap_a(const Node& a, const Seen& b, const Node&) const { return overlap(a, b); }
  bool overlap_b(const Node& b, const Seen& a, const Node&) const { return overlap(b, a); }
  Vec placed(const Vec& corner) const { return corner + t; }
  static Vec turned(const Vec& normal) { return normal; }
  static Vec turned_back(const Vec& normal) { return normal; }
};

/// B is rotated and translated. One box is tested against both children of the other, so values
/// common to both tests are computed once.
struct Turned {
  Vec rows[3];
  Vec columns[3];
  Vec row_sizes[3];
  Vec column_sizes[3];
  Vec t;
  Vec back;

  explicit Turned(const Matrix& pose) : t(pose.translation) {
    for (int i = 0; i < 3; ++i) {
      rows[i] = pose.rows[i];
      row_sizes[i] = magnitudes(rows[i]);
    }
    columns[0] = {rows[0].x, rows[1].x, rows[2].x};
    columns[1] = {rows[0].y, rows[1].y, rows[2].y};
    columns[2] = {rows[0].z, rows[1].z, rows[2].z};
    for (int i = 0; i < 3; ++i) {
      column_sizes[i] = magnitudes(columns[i]);
    }
    back = product(columns, t);
  }
  static Vec product(const Vec (&by)[3], const Vec& v) {
    return {dot(by[0], v), dot(by[1], v), dot(by[2], v)};
  }
  Seen seen_of_a(const Node& a) const {
    return {product(columns, a.middle) - back, product(column_sizes, a.half)};
  }
  Seen seen_of_b(const Node& b) const {
    return {product(rows, b.middle) + t, product(row_sizes, b.half)};
  }
  /// Tests the axes of the box's own frame first, then the axes of `other`'s frame.
  static bool overlap(const Node& box, const Seen& seen, const Vec (&to_other)[3],
                      const Vec (&sizes)[3], const Node& other) {
    const Vec way = seen.middle - box.middle;
    return !parts(way.x, box.half.x, seen.half.x) && !parts(way.y, box.half.y, seen.half.y) &&
           !parts(way.z, box.half.z, seen.half.z) &&
           !parts(dot(to_other[0], way), other.half.x, dot(sizes[0], box.half)) &&
           !parts(dot(to_other[1], way), other.half.y, dot(sizes[1], box.half)) &&
           !parts(dot(to_other[2], way), other.half.z, dot(sizes[2], box.half));
  }
  bool overlap_a(const Node& a, const Seen& seen_b, const Node& b) const {
    return overlap(a, seen_b, columns, column_sizes, b);
  }
  bool overlap_b(const Node& b, const Seen& seen_a, const Node& a) const {
    return overlap(b, seen_a, rows, row_sizes, a);
  }
  Vec placed(const Vec& corner) const { return product(rows, corner) + t; }
  Vec turned(const Vec& normal) const { return product(rows, normal); }
  Vec turned_back(const Vec& normal) const { return product(columns, normal); }
};

class FloatTree : public Library {
 public:
  void set_meshes(const Mesh& a, const Mesh& b) override {
    a_.build(a);
    b_.build(b);
  }

  void set_pose(const Pose& pose) override { pose_ = matrix_of(pose); }

  uint32_t query(bool first) override {
    return pose_.is_rotated ? walk(first, Turned(pose_)) : walk(first, Moved(pose_));
  }

 private:
  struct Element {
    const Node* a;
    const Node* b;
  };

  template <class Placed>
  uint32_t walk(bool first, const Placed& placed) const {
    const Node* const nodes_a = a_.nodes();
    const Node* const nodes_b = b_.nodes();
    Element stack[128];
    Element* top = stack;
    uint32_t found = 0;
    const Node* a = nodes_a;
    const Node* b = nodes_b;
    if (!placed.overlap_a(*a, placed.seen_of_b(*b), *b)) {
      return 0;
    }
    for (;;) {
      // The pair overlaps.
      if (b->is_leaf() ? !a->is_leaf() : a->volume > b->volume) {
        const Seen seen = placed.seen_of_b(*b);
        const Node* const child = nodes_a + a->first;
        const bool near = placed.overlap_a(child[0], seen, *b);
        if (placed.overlap_a(child[1], seen, *b)) {
          a = child + 1;
          if (!near) {
            continue;
          }
          *top++ = {a, b};
        }
        if (near) {
          a = child;
          continue;
        }
      } else if (!b->is_leaf()) {
        const Seen seen = placed.seen_of_a(*a);
        const Node* const child = nodes_b + b->first;
        const bool near = placed.overlap_b(child[0], seen, *a);
        if (placed.overlap_b(child[1], seen, *a)) {
          b = child + 1;
          if (!near) {
            continue;
          }
          *top++ = {a, b};
        }
        if (near) {
          b = child;
          continue;
        }
      } else {
        found += intersect(placed, *a, *b) ? 1 : 0;
        if (first && found != 0) {
          return found;
        }
      }
      if (top == stack) {
        return found;
      }
      --top;
      a = top->a;
      b = top->b;
    }
  }

  template <class Placed>
  bool intersect(const Placed& placed, const Node& leaf_a, const Node& leaf_b) const {
    const Flat& a = a_.triangles()[leaf_a.first];
    const Flat& b = b_.triangles()[leaf_b.first];
    // Planes are transformed first: they separate most pairs, and need one vector each.
    const Heights of_b(placed.turned_back(a.normal), a.offset - dot(a.normal, placed.t), b.corner);
    if (of_b.are_on_one_side()) {
      return false;
    }
    const Vec normal = placed.turned(b.normal);
    const Heights of_a(normal, b.offset + dot(normal, placed.t), a.corner);
    if (of_a.are_on_one_side()) {
      return false;
    }
    const Vec corners[3] = {placed.placed(b.corner[0]), placed.placed(b.corner[1]),
                            placed.placed(b.corner[2])};
    return crossing_intersect(a.corner, corners, a.normal, normal, of_a, of_b);
  }

  Tree a_;
  Tree b_;
  Matrix pose_{};
};

}  // namespace

Library& float_tree() {
  static FloatTree* const library = new FloatTree;
  return *library;
}

}  // namespace compare
