// How a tree is built: how deep its leaves lie, how full they are, how many children nodes have.
#ifndef FLASHBVH_TOOLS_REPORT_TREE_SHAPE_HPP
#define FLASHBVH_TOOLS_REPORT_TREE_SHAPE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

/// How often each number occurs, from 0 on.
using Histogram = std::vector<std::uint64_t>;

struct TreeShape {
  Histogram nodes_by_depth;     ///< the root has depth 0
  Histogram leaves_by_depth;    ///< as long
  Histogram leaves_by_size;     ///< by triangles
  Histogram nodes_by_children;  ///< nodes that are no leaves
};

TreeShape shape_of(const AnyTree& any);

/// A box of the tree and whether it is a leaf's.
struct NodeBox {
  detail::Box box;
  bool is_leaf;
};

/// The boxes at a depth, in array order.
std::vector<NodeBox> boxes_at(const AnyTree& any, std::uint32_t depth);

/// The same as tables with bars.
std::string histograms(const TreeShape& shape);

}  // namespace flashbvh::tool

#endif
