#include "evaluate/needed_work.hpp"

#include <algorithm>
#include <numeric>

namespace flashbvh::tool {

NeededWork needed_work(std::vector<std::uint64_t> work) {
  std::sort(work.begin(), work.end());
  const double sum = std::accumulate(work.begin(), work.end(), 0.0);
  return {work.back(), work[(work.size() * 99 + 99) / 100 - 1],
          sum / static_cast<double>(work.size())};
}

TreeSize tree_size(const ImageHeader& header) {
  return {header.depth, header.arity, header.leaf_size, header.leaf_count, header.triangle_count};
}

}  // namespace flashbvh::tool
