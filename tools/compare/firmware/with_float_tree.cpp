// The paper's tree and its algorithm 2, in binary32: boxes along the axes, split top-down at the
// median of the longest one until a triangle is left; a stack, the larger volume descended. Under
// rotation boxes are told apart by the axes of both frames.
#include <algorithm>
#include <vector>

#include "asked_of.hpp"
#include "float_triangles.hpp"

using flashbvh::Pose;
using flashbvh::PostMesh;

namespace compare {
namespace {

struct Node {
  float middle[3];
  float half[3];
  float volume;
  uint32_t first;  ///< its children: this one and the next; of a leaf the triangle
  bool is_leaf;
};

struct Corners {
  Vec corner[3];
};

class Tree {
 public:
  void build(const PostMesh& mesh) {
    triangles_.clear();
    for (uint32_t i = 0; i < mesh.triangle_count; ++i) {
      Corners corners;
      for (int k = 0; k < 3; ++k) {
        float at[3];
        set_vertex(mesh, mesh.triangles[i].corner[k], at);
        corners.corner[k] = {at[0], at[1], at[2]};
      }
      triangles_.push_back(corners);
    }
    nodes_.assign(1, Node());
    fill(0, 0, static_cast<uint32_t>(triangles_.size()));
  }

  const Node& node(uint32_t i) const { return nodes_[i]; }
  const Vec (&triangle(uint32_t i) const)[3] { return triangles_[i].corner; }

 private:
  static float of(const Vec& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  void fill(uint32_t at, uint32_t begin, uint32_t end) {
    int longest = 0;
    Node node{};
    node.volume = 1;
    for (int axis = 0; axis < 3; ++axis) {
      float low = 1e30f;
      float high = -1e30f;
      for (uint32_t i = begin; i < end; ++i) {
        for (const Vec& v : triangles_[i].corner) {
          low = std::min(low, of(v, axis));
          high = std::max(high, of(v, axis));
        }
      }
      node.middle[axis] = (low + high) / 2;
      node.half[axis] = std::max(high - node.middle[axis], node.middle[axis] - low);
      node.volume *= node.half[axis];
      longest = node.half[axis] > node.half[longest] ? axis : longest;
    }
    node.is_leaf = end - begin == 1;
    node.first = node.is_leaf ? begin : static_cast<uint32_t>(nodes_.size());
    nodes_[at] = node;
    if (node.is_leaf) {
      return;
    }
    const uint32_t half = (begin + end) / 2;
    const auto sum = [longest](const Corners& t) {
      return of(t.corner[0], longest) + of(t.corner[1], longest) + of(t.corner[2], longest);
    };
    std::nth_element(triangles_.begin() + begin, triangles_.begin() + half,
                     triangles_.begin() + end,
                     [&](const Corners& x, const Corners& y) { return sum(x) < sum(y); });
    nodes_.resize(nodes_.size() + 2);
    fill(node.first, begin, half);
    fill(node.first + 1, half, end);
  }

  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

float absolute(float x) {
  return x < 0 ? -x : x;
}

class FloatTree : public Library {
 public:
  void set_meshes(const PostMesh& a, const PostMesh& b) override {
    a_.build(a);
    b_.build(b);
  }

  void set_pose(const Pose& pose) override {
    is_rotated_ = !pose.is_translation();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        rotation_[row][column] = rotation_of(pose, row, column);
        size_[row][column] = absolute(rotation_[row][column]);
      }
      translation_[row] = translation_of(pose, row);
    }
  }

  uint32_t ask(bool first) override {
    return is_rotated_ ? walk(first, [this](const Node& a, const Node& b) { return rotated(a, b); })
                       : walk(first, [this](const Node& a, const Node& b) { return moved(a, b); });
  }

 private:
  struct Element {
    uint32_t a, b;
  };

  template <class Overlap>
  uint32_t walk(bool first, Overlap overlap) {
    Element stack[128];
    stack[0] = {0, 0};
    uint32_t found = 0;
    for (int depth = 1; depth != 0;) {
      const Element pair = stack[--depth];
      const Node& a = a_.node(pair.a);
      const Node& b = b_.node(pair.b);
      if (!overlap(a, b)) {
        continue;
      }
      if (a.is_leaf && b.is_leaf) {
        found += intersect(a.first, b.first) ? 1 : 0;
        if (first && found != 0) {
          break;
        }
      } else if (b.is_leaf || (!a.is_leaf && a.volume >= b.volume)) {
        stack[depth++] = {a.first + 1, pair.b};
        stack[depth++] = {a.first, pair.b};
      } else {
        stack[depth++] = {pair.a, b.first + 1};
        stack[depth++] = {pair.a, b.first};
      }
    }
    return found;
  }

  bool moved(const Node& a, const Node& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (absolute(b.middle[axis] + translation_[axis] - a.middle[axis]) >
          a.half[axis] + b.half[axis]) {
        return false;
      }
    }
    return true;
  }

  bool rotated(const Node& a, const Node& b) const {
    float way[3];
    for (int i = 0; i < 3; ++i) {
      const float(&row)[3] = rotation_[i];
      const float(&size)[3] = size_[i];
      way[i] = row[0] * b.middle[0] + row[1] * b.middle[1] + row[2] * b.middle[2] +
               translation_[i] - a.middle[i];
      if (absolute(way[i]) >
          a.half[i] + size[0] * b.half[0] + size[1] * b.half[1] + size[2] * b.half[2] + kSlack) {
        return false;
      }
    }
    for (int i = 0; i < 3; ++i) {
      const float along =
          rotation_[0][i] * way[0] + rotation_[1][i] * way[1] + rotation_[2][i] * way[2];
      if (absolute(along) > b.half[i] + size_[0][i] * a.half[0] + size_[1][i] * a.half[1] +
                                size_[2][i] * a.half[2] + kSlack) {
        return false;
      }
    }
    return true;
  }

  bool intersect(uint32_t of_a, uint32_t of_b) const {
    Vec b[3];
    for (int i = 0; i < 3; ++i) {
      const Vec v = b_.triangle(of_b)[i];
      b[i] = is_rotated_ ? Vec{dot(row(0), v), dot(row(1), v), dot(row(2), v)} : v;
      b[i] = b[i] + Vec{translation_[0], translation_[1], translation_[2]};
    }
    return triangles_intersect(a_.triangle(of_a), b);
  }

  Vec row(int i) const { return {rotation_[i][0], rotation_[i][1], rotation_[i][2]}; }

  /// For what turning rounds off.
  static constexpr float kSlack = 1e-5f;

  Tree a_;
  Tree b_;
  bool is_rotated_ = false;
  float rotation_[3][3];
  float size_[3][3];
  float translation_[3];
};

}  // namespace

Library& float_tree() {
  static FloatTree* const library = new FloatTree;
  return *library;
}

}  // namespace compare
