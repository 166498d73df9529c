// Meshes' trees: each node's box contains everything below it.
#include "checks.hpp"

namespace robot_check {
namespace {

/// The largest depth of a tree that the check follows.
constexpr std::uint32_t kMostDepth = 1000;

class Tree {
 public:
  explicit Tree(const Mesh& mesh) : mesh_(mesh), is_seen_(mesh.node_count) {}

  /// Empty if all holds; else the error.
  std::string check() {
    std::string wrong = below(0, 0);
    if (wrong.empty() && (leaves_ != mesh_.leaf_count || visited_ != mesh_.node_count)) {
      wrong = "nodes or leaves that no link leads to";
    }
    return wrong;
  }

 private:
  struct Bounds {
    std::int32_t low[3], high[3];
  };
  std::uint32_t half(std::uint32_t node, std::uint32_t i) const {
    const std::size_t at = std::size_t{16} * node + std::size_t{2} * i;
    return at + 1 < mesh_.nodes.size() ? mesh_.nodes[at] | mesh_.nodes[at + 1] << 8 : 0;
  }
  Bounds bounds(std::uint32_t node) const {
    const auto low = [&](std::uint32_t i) {
      return 16384 - static_cast<std::int32_t>(half(node, i));
    };
    const auto high = [&](std::uint32_t i) {
      return static_cast<std::int32_t>(half(node, i)) - 16384;
    };
    return {{low(2), low(3), low(5)}, {high(0), high(1), high(4)}};
  }

  std::string below(std::uint32_t node, std::uint32_t depth) {
    if (node >= mesh_.node_count || is_seen_[node] || depth > kMostDepth) {
      return text("a link leads to node ", node, ", out of the array, twice or too deep");
    }
    is_seen_[node] = true;
    ++visited_;
    const std::uint32_t data = half(node, 7);
    if ((data & 0x8000) != 0) {
      return leaf(node, data & 0x7FFF);
    }
    if (node + 1 >= mesh_.node_count) {
      return text("node ", node, " has no child");
    }
    const std::uint32_t last = node + 1;
    for (std::uint32_t child = half(last, 6);; child = half(child, 6)) {
      if (child >= mesh_.node_count || is_seen_[child]) {
        return text("the children of node ", node, " form no ring");
      }
      if (!holds(bounds(node), bounds(child))) {
        return text("the box of node ", node, " does not hold that of node ", child);
      }
      std::string wrong = below(child, depth + 1);
      if (!wrong.empty() || child == last) {
        return wrong;
      }
    }
  }

  std::string leaf(std::uint32_t node, std::uint32_t number) {
    ++leaves_;
    if (number >= mesh_.leaf_count) {
      return text("node ", node, " is leaf ", number, " of ", mesh_.leaf_count);
    }
    const std::uint32_t first = mesh_.leaf_offsets[number];
    const std::uint32_t end = mesh_.leaf_offsets[number + 1];
    if (first >= end || end > mesh_.corners.size()) {
      return text("leaf ", number, " has no triangles, or more than there are");
    }
    for (std::uint32_t i = first; i < end; ++i) {
      for (const std::uint16_t corner : mesh_.corners[i]) {
        const auto& v = mesh_.lattice[corner];
        if (!holds(bounds(node), {{v[0], v[1], v[2]}, {v[0], v[1], v[2]}})) {
          return text("the box of leaf ", number, " does not hold vertex ", corner,
                      ": queries miss its triangle");
        }
      }
    }
    return "";
  }

  static bool holds(const Bounds& outer, const Bounds& inner) {
    for (int i = 0; i < 3; ++i) {
      if (outer.low[i] > inner.low[i] || outer.high[i] < inner.high[i]) {
        return false;
      }
    }
    return true;
  }

  const Mesh& mesh_;
  std::vector<bool> is_seen_;
  std::uint32_t leaves_ = 0;
  std::uint32_t visited_ = 0;
};

}  // namespace

void check_trees(const Robot& robot, Report& report) {
  std::size_t nodes = 0;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const std::string wrong = Tree(robot.links[i].mesh).check();
    nodes += robot.links[i].mesh.node_count;
    if (!wrong.empty()) {
      report.refuse("mesh of link " + robot.link_name(i) + ": " + wrong);
    }
  }
  report.end("trees", text(nodes, " nodes: each box holds what is below it"));
}

}  // namespace robot_check
