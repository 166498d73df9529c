// Reinsertion: removes a subtree and inserts it again where it costs least (Bittner, Hapala and
// Havran 2013, "Fast insertion-based optimization of bounding volume hierarchies"). Takes each
// subtree in turn, those of large surface first.
//
// A place costs the surface of the new parent there, and the growth of all nodes above. Growth can
// only increase on the way down, and the new parent's surface is at least the subtree's. So the
// search takes nodes in order of growth, and ends when growth and the subtree's surface reach the
// best cost. Invariant: the best cost starts as the old place's, so the tree's cost never grows,
// whenever the search ends. Ties: the old place, then the first one in order of growth and of node.
#include <algorithm>
#include <functional>
#include <numeric>

#include "bake/binary_tree.hpp"
#include "bake/measure.hpp"

namespace flashbvh::bake {
namespace {

bool same(const Box& p, const Box& q) {
  return p.lower.x == q.lower.x && p.lower.y == q.lower.y && p.lower.z == q.lower.z &&
         p.upper.x == q.upper.x && p.upper.y == q.upper.y && p.upper.z == q.upper.z;
}

/// Most places that a search visits: as good as no limit in a surface. In a heap of triangles that
/// all overlap each other, a full search would visit every node.
constexpr int kMostPlaces = 256;

class Reinsertion {
 public:
  explicit Reinsertion(BinaryTree& tree) : nodes_(tree.nodes) {}

  /// Reinserts all subtrees once.
  void pass() {
    std::vector<std::uint32_t> order(nodes_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return nodes_[i].surface != nodes_[j].surface ? nodes_[i].surface > nodes_[j].surface : i < j;
    });
    for (const std::uint32_t node : order) {
      // The root's children stay: taking one out would leave its sibling as the root.
      if (node != 0 && nodes_[node].parent != 0) {
        reinsert(node);
      }
    }
  }

 private:
  struct Place {
    std::uint64_t growth;  ///< of all nodes above
    std::uint32_t node;    ///< sibling that the subtree would get

    bool operator>(const Place& other) const {
      return growth != other.growth ? growth > other.growth : node > other.node;
    }
  };

  void reinsert(std::uint32_t node) {
    const std::uint32_t parent = nodes_[node].parent;
    const std::uint32_t old = nodes_[parent].children[nodes_[parent].children[0] == node ? 1 : 0];
    replace_child(nodes_[parent].parent, parent, old);
    refit(nodes_[old].parent);
    const std::uint32_t place = best_place(node, old);
    replace_child(nodes_[place].parent, place, parent);
    nodes_[parent].children = {place, node};
    nodes_[place].parent = parent;
    tighten(parent);
    refit(nodes_[parent].parent);
  }

  void replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
    std::array<std::uint32_t, 2>& children = nodes_[parent].children;
    children[children[0] == child ? 0 : 1] = by;
    nodes_[by].parent = parent;
  }

  /// Tightens a box. False if it was tight.
  bool tighten(std::uint32_t node) {
    BinaryNode& at = nodes_[node];
    const Box box = join(nodes_[at.children[0]].box, nodes_[at.children[1]].box);
    if (same(box, at.box)) {
      return false;
    }
    at.box = box;
    at.surface = half_surface(box);
    return true;
  }

  /// Refits upwards from a node whose children have changed.
  void refit(std::uint32_t node) {
    while (node != kNoNode && tighten(node)) {
      node = nodes_[node].parent;
    }
  }

  std::uint64_t surface_with(std::uint32_t place, const BinaryNode& subtree) const {
    return half_surface(join(nodes_[place].box, subtree.box));
  }

  /// The cost of putting the subtree next to `place`, from the place up.
  std::uint64_t cost_at(std::uint32_t place, const BinaryNode& subtree) const {
    std::uint64_t cost = surface_with(place, subtree);
    for (std::uint32_t at = nodes_[place].parent; at != kNoNode; at = nodes_[at].parent) {
      cost += surface_with(at, subtree) - nodes_[at].surface;
    }
    return cost;
  }

  std::uint32_t best_place(std::uint32_t node, std::uint32_t old) {
    const BinaryNode& subtree = nodes_[node];
    std::uint64_t least = cost_at(old, subtree);
    std::uint32_t best = old;
    heap_.assign(1, {0, 0});
    for (int left = kMostPlaces;
         left > 0 && !heap_.empty() && heap_.front().growth + subtree.surface < least; --left) {
      const Place place = heap_.front();
      std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
      heap_.pop_back();
      const BinaryNode& at = nodes_[place.node];
      const std::uint64_t cost = place.growth + surface_with(place.node, subtree);
      if (cost < least && place.node != 0) {
        least = cost;
        best = place.node;
      }
      const std::uint64_t growth = cost - at.surface;
      if (!at.is_leaf() && growth + subtree.surface < least) {
        for (const std::uint32_t child : at.children) {
          heap_.push_back({growth, child});
          std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
        }
      }
    }
    return best;
  }

  std::vector<BinaryNode>& nodes_;
  std::vector<Place> heap_;
};

/// Later passes gain little more.
constexpr int kPasses = 2;

}  // namespace

void reinsert_all(BinaryTree& tree) {
  Reinsertion reinsertion(tree);
  for (int i = 0; i < kPasses; ++i) {
    reinsertion.pass();
  }
}

}  // namespace flashbvh::bake
