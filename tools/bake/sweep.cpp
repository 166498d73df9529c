// The surface area heuristic, top-down. A node's triangles are sorted by the centres of their boxes
// along each of the three axes. Of all splits, it takes the one with the least
//   surface(left) * triangles(left) + surface(right) * triangles(right)
// (MacDonald and Booth 1990; the sweep over presorted lists: Wald and Havran 2006).
//
// Invariant: the triangles of a pending node are the same range of all three lists, each sorted by
// centre, ties by number. Splits of equal cost: the one nearest to the middle, then the first axis,
// then the first position; so indistinguishable triangles are halved.
#include <algorithm>
#include <numeric>

#include "bake/binary_tree.hpp"
#include "bake/measure.hpp"

namespace flashbvh::bake {
namespace {

/// Twice the coordinate of the box's centre.
std::int32_t centre(const Box& box, std::size_t axis) {
  return axis == 0   ? box.lower.x + box.upper.x
         : axis == 1 ? box.lower.y + box.upper.y
                     : box.lower.z + box.upper.z;
}

struct NodeRange {
  std::uint32_t node;
  std::uint32_t first;
  std::uint32_t end;
};

/// A split of one list before position `at`.
struct Split {
  std::uint64_t cost;
  std::uint32_t unbalance;  ///< difference of the sides' numbers of triangles
  std::size_t axis;
  std::uint32_t at;

  bool better_than(const Split& other) const {
    return cost != other.cost ? cost < other.cost : unbalance < other.unbalance;
  }
};

class Sweep {
 public:
  explicit Sweep(const LatticeMesh& mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
      boxes_.push_back(box_of(mesh, triangle));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lists_[axis].resize(count);
      std::iota(lists_[axis].begin(), lists_[axis].end(), 0u);
      std::sort(lists_[axis].begin(), lists_[axis].end(), [&](std::uint32_t i, std::uint32_t j) {
        return std::make_pair(centre(boxes_[i], axis), i) <
               std::make_pair(centre(boxes_[j], axis), j);
      });
    }
    after_.resize(count);
    is_right_.resize(count);
    scratch_.resize(count);
  }

  BinaryTree build() {
    tree_.nodes.reserve(2 * boxes_.size() - 1);
    std::vector<NodeRange> pending = {
        added({0, 0, static_cast<std::uint32_t>(boxes_.size())}, kNoNode)};
    while (!pending.empty()) {
      const NodeRange range = pending.back();
      pending.pop_back();
      if (range.end - range.first == 1) {
        tree_.nodes[range.node].triangle = lists_[0][range.first];
        continue;
      }
      const Split split = best_split(range);
      partition(range, split);
      const NodeRange left = added({0, range.first, split.at}, range.node);
      const NodeRange right = added({0, split.at, range.end}, range.node);
      tree_.nodes[range.node].children = {left.node, right.node};
      pending.push_back(right);
      pending.push_back(left);
    }
    return std::move(tree_);
  }

 private:
  /// Adds a node for the range.
  NodeRange added(NodeRange range, std::uint32_t parent) {
    range.node = static_cast<std::uint32_t>(tree_.nodes.size());
    BinaryNode node;
    node.parent = parent;
    node.box = boxes_[lists_[0][range.first]];
    for (std::uint32_t at = range.first; at < range.end; ++at) {
      node.box = join(node.box, boxes_[lists_[0][at]]);
    }
    node.surface = half_surface(node.box);
    tree_.nodes.push_back(node);
    return range;
  }

  Split best_split(const NodeRange& range) {
    Split best = best_split_along(range, 0);
    for (std::size_t axis = 1; axis < 3; ++axis) {
      const Split split = best_split_along(range, axis);
      best = split.better_than(best) ? split : best;
    }
    return best;
  }

  Split best_split_along(const NodeRange& range, std::size_t axis) {
    const std::vector<std::uint32_t>& list = lists_[axis];
    Box box = boxes_[list[range.end - 1]];
    for (std::uint32_t at = range.end - 1; at > range.first; --at) {
      box = join(box, boxes_[list[at]]);
      after_[at] = half_surface(box) * (range.end - at);
    }
    box = boxes_[list[range.first]];
    Split best = {UINT64_MAX, UINT32_MAX, axis, 0};
    for (std::uint32_t at = range.first + 1; at < range.end; ++at) {
      box = join(box, boxes_[list[at - 1]]);
      const std::uint32_t left = at - range.first;
      const std::uint32_t right = range.end - at;
      const Split split = {half_surface(box) * left + after_[at],
                           left > right ? left - right : right - left, axis, at};
      best = split.better_than(best) ? split : best;
    }
    return best;
  }

  /// Moves the left side to the front of all three lists; each side keeps its order.
  void partition(const NodeRange& range, const Split& split) {
    for (std::uint32_t at = range.first; at < range.end; ++at) {
      is_right_[lists_[split.axis][at]] = at >= split.at ? 1 : 0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == split.axis) {
        continue;
      }
      std::uint32_t left = range.first;
      std::uint32_t right = split.at;
      for (std::uint32_t at = range.first; at < range.end; ++at) {
        const std::uint32_t triangle = lists_[axis][at];
        scratch_[is_right_[triangle] != 0 ? right++ : left++] = triangle;
      }
      std::copy(scratch_.begin() + range.first, scratch_.begin() + range.end,
                lists_[axis].begin() + range.first);
    }
  }

  BinaryTree tree_;
  std::vector<Box> boxes_;                           ///< of the triangles
  std::array<std::vector<std::uint32_t>, 3> lists_;  ///< triangles, by axis
  std::vector<std::uint64_t> after_;                 ///< [position]: cost of it and all after it
  std::vector<char> is_right_;                       ///< by triangle
  std::vector<std::uint32_t> scratch_;
};

}  // namespace

BinaryTree sweep(const LatticeMesh& mesh) {
  return Sweep(mesh).build();
}

}  // namespace flashbvh::bake
