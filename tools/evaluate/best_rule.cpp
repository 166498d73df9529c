// Dynamic programming over pairs of nodes. best(a, b) is 1 if the boxes are disjoint or both nodes
// are leaves. Else it is 1 plus the smaller of two sums: of best(child of a, b) over a's children,
// and of best(a, child of b) over b's. The visits below a pair do not depend on the path to it.
#include "evaluate/run.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <vector>

#include "flashbvh/lattice.hpp"

namespace flashbvh::tool {
namespace {

bool overlap(std::int32_t lower_a, std::int32_t upper_a, std::int32_t lower_b, std::int32_t upper_b,
             std::int32_t along) {
  return upper_a - lower_b >= along && upper_b - lower_a >= -along;
}

class BestRule {
 public:
  BestRule(const bake::BuildTree& a, const bake::BuildTree& b, const Point& translation)
      : a_(a), b_(b), translation_(translation) {}

  /// Recursive; its depth is at most the sum of both trees' depths.
  std::uint64_t best(std::uint32_t i, std::uint32_t j) {
    const bake::BuildNode& node_a = a_.nodes[i];
    const bake::BuildNode& node_b = b_.nodes[j];
    if (!boxes_overlap(node_a.box, node_b.box) || (node_a.is_leaf() && node_b.is_leaf())) {
      return 1;
    }
    const std::uint64_t key = std::uint64_t{i} << 32 | j;
    if (const auto known = known_.find(key); known != known_.end()) {
      return known->second;
    }
    constexpr std::uint64_t no_choice = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t into_a = node_a.is_leaf() ? no_choice : 0;
    std::uint64_t into_b = node_b.is_leaf() ? no_choice : 0;
    for (const std::uint32_t child : node_a.children) {
      into_a += best(child, j);
    }
    for (const std::uint32_t child : node_b.children) {
      into_b += best(i, child);
    }
    return known_[key] = 1 + std::min(into_a, into_b);
  }

 private:
  bool boxes_overlap(const Box& a, const Box& b) const {
    return overlap(a.lower.x, a.upper.x, b.lower.x, b.upper.x, translation_.x) &&
           overlap(a.lower.y, a.upper.y, b.lower.y, b.upper.y, translation_.y) &&
           overlap(a.lower.z, a.upper.z, b.lower.z, b.upper.z, translation_.z);
  }

  const bake::BuildTree& a_;
  const bake::BuildTree& b_;
  Point translation_;
  std::unordered_map<std::uint64_t, std::uint64_t> known_;
};

}  // namespace

std::uint64_t best_rule_visits(const bake::BuildTree& a, const bake::BuildTree& b,
                               const Point& translation) {
  return BestRule(a, b, translation).best(0, 0);
}

}  // namespace flashbvh::tool
