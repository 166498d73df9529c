#include "report/tree_shape.hpp"

#include <algorithm>
#include <numeric>

#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

void count(Histogram& histogram, std::size_t number) {
  if (histogram.size() <= number) {
    histogram.resize(number + 1, 0);
  }
  ++histogram[number];
}

/// In both layouts a node comes before its subtree: its parent is the latest node one level up.
template <class Levelled>
Histogram children_of_nodes(const Levelled& tree) {
  Histogram children(tree.node_count, 0);
  std::vector<std::uint32_t> latest;  // by depth
  for (std::uint32_t node = 0; node < tree.node_count; ++node) {
    const std::uint32_t depth = tree.level(node);
    latest.resize(depth);
    if (depth != 0) {
      ++children[latest.back()];
    }
    latest.push_back(node);
  }
  return children;
}

template <class Levelled>
TreeShape shape(const Levelled& tree) {
  TreeShape shape;
  const Histogram children = children_of_nodes(tree);
  for (std::uint32_t i = 0; i < tree.node_count; ++i) {
    const auto& node = tree.nodes[i];
    count(shape.nodes_by_depth, tree.level(i));
    if (node.is_leaf()) {
      count(shape.leaves_by_depth, tree.level(i));
      count(shape.leaves_by_size,
            tree.end_triangle(node.leaf()) - tree.first_triangle(node.leaf()));
    } else {
      count(shape.nodes_by_children, children[i]);
    }
  }
  return shape;
}

/// Rows of a histogram; more numbers than that share rows.
constexpr std::size_t kMostRows = 24;

/// The head of the bars' column, for who can't see them.
constexpr const char* kBar = "<span class=hide>bar</span>";

/// Sums of `width` numbers each, from `first` on.
struct Bins {
  std::size_t first;
  std::size_t width;
  Histogram sums;

  std::string label(std::size_t bin, std::size_t end) const {
    const std::size_t low = first + bin * width;
    const std::size_t high = std::min(low + width, end) - 1;
    return concat(low, (high == low ? "" : concat("&ndash;", high)));
  }
};

Bins bins_of(const Histogram& histogram, std::size_t first) {
  const std::size_t count = histogram.size() - first;
  Bins bins = {first, (count + kMostRows - 1) / kMostRows, {}};
  bins.sums.resize((count + bins.width - 1) / bins.width, 0);
  for (std::size_t i = first; i < histogram.size(); ++i) {
    bins.sums[(i - first) / bins.width] += histogram[i];
  }
  return bins;
}

std::string piece(const char* style, std::uint64_t value, std::uint64_t most) {
  const double share = 100.0 * static_cast<double>(value) / static_cast<double>(most);
  return value == 0 ? ""
                    : std::string("<span class=") + style + " style=\"width:" + fixed(share, 1) +
                          "%\"></span>";
}

std::string bar_cell(const std::string& pieces) {
  return "<div class=row>" + pieces + "</div>";
}

/// The first number that occurs.
std::size_t least(const Histogram& histogram) {
  const auto some = std::find_if(histogram.begin(), histogram.end(),
                                 [](std::uint64_t count) { return count != 0; });
  return static_cast<std::size_t>(some - histogram.begin());
}

std::string depth_table(const TreeShape& shape) {
  const Bins nodes = bins_of(shape.nodes_by_depth, 0);
  const Bins leaves = bins_of(shape.leaves_by_depth, 0);
  const std::uint64_t most = *std::max_element(nodes.sums.begin(), nodes.sums.end());
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < nodes.sums.size(); ++i) {
    const std::uint64_t inner = nodes.sums[i] - leaves.sums[i];
    rows.push_back({nodes.label(i, shape.nodes_by_depth.size()), grouped(inner),
                    grouped(leaves.sums[i]),
                    bar_cell(piece("inner", inner, most) + piece("leaf", leaves.sums[i], most))});
  }
  return table("Nodes by depth",
               {{"depth", true},
                {"<i class=\"key inner\"></i>with children", true},
                {"<i class=\"key leaf\"></i>leaves", true},
                {kBar, false}},
               rows);
}

/// Counts of one kind.
std::string one_column(const std::string& caption, const char* number, const char* what,
                       const Histogram& histogram, const char* style) {
  const Bins bins = bins_of(histogram, least(histogram));
  const std::uint64_t most = *std::max_element(bins.sums.begin(), bins.sums.end());
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < bins.sums.size(); ++i) {
    rows.push_back({bins.label(i, histogram.size()), grouped(bins.sums[i]),
                    bar_cell(piece(style, bins.sums[i], most))});
  }
  return table(caption, {{number, true}, {what, true}, {kBar, false}}, rows);
}

}  // namespace

TreeShape shape_of(const AnyTree& any) {
  return std::visit([](const auto& tree) { return shape(tree); }, any);
}

std::vector<NodeBox> boxes_at(const AnyTree& any, std::uint32_t depth) {
  return std::visit(
      [&](const auto& tree) {
        std::vector<NodeBox> boxes;
        for (std::uint32_t i = 0; i < tree.node_count; ++i) {
          if (tree.level(i) == depth) {
            boxes.push_back({detail::unpack(tree.nodes[i].box), tree.nodes[i].is_leaf()});
          }
        }
        return boxes;
      },
      any);
}

std::string histograms(const TreeShape& shape) {
  std::string html = "<div class=hist>\n<h3>Shape of the tree</h3>\n" + depth_table(shape);
  if (shape.leaves_by_size.size() == 2) {
    html += "<p>Every leaf holds one triangle.</p>\n";
  } else {
    html += one_column("Leaves by number of triangles", "triangles", "leaves", shape.leaves_by_size,
                       "leaf");
  }
  if (!shape.nodes_by_children.empty()) {
    html += one_column("Nodes by number of children", "children", "nodes", shape.nodes_by_children,
                       "inner");
  }
  return html + "</div>\n";
}

}  // namespace flashbvh::tool
