// Meshes as drawn, in doubles, and whether two come near each other. Shares no code with the code
// that bakes, simplifies or guards them.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/kinematics.hpp"
#include "support/surface.hpp"

namespace flashbvh::test {

using tool::Vector3;

class DrawnMesh {
 public:
  explicit DrawnMesh(std::vector<FloatTriangle> triangles);

  /// `frame`: the frame of `other` in this mesh's frame.
  bool is_nearer(const DrawnMesh& other, const tool::Transform& frame, double distance) const;

 private:
  struct Node {
    Vector3 centre;
    Vector3 half;         ///< of the node's box
    std::uint32_t first;  ///< triangle of a leaf, or the right child; the left one is next
    std::uint32_t count;  ///< 0: an inner node
    double size() const { return half[0] + half[1] + half[2]; }
  };
  struct Query {
    const DrawnMesh& b;
    const tool::Transform& frame;
    double distance;
  };
  void build(std::uint32_t first, std::uint32_t count);
  double gap(const Query& query, const Node& a, const Node& b) const;
  bool is_nearer(const Query& query, std::uint32_t a, std::uint32_t b) const;
  bool are_leaves_nearer(const Query& query, const Node& a, const Node& b) const;

  std::vector<Node> nodes_;
  std::vector<FloatTriangle> triangles_;
};

}  // namespace flashbvh::test
