// Huffman, "A Method for the Construction of Minimum-Redundancy Codes", 1952; canonical codes as in
// RFC 1951, section 3.2.2. Where a code would be too long the counts are flattened until none is.
#include "report/huffman.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace flashbvh::report {
namespace {

constexpr unsigned kMostBits = 15;

struct Subtree {
  std::uint64_t count;
  std::size_t number;  ///< settles ties, so that the code is the same everywhere

  bool operator>(const Subtree& other) const {
    return std::tie(count, number) > std::tie(other.count, other.number);
  }
};

/// How deep each symbol lies in the tree of pairs, the two rarest joined first.
std::vector<unsigned> depths(const std::vector<std::uint64_t>& counts) {
  std::priority_queue<Subtree, std::vector<Subtree>, std::greater<>> rarest;
  for (std::size_t symbol = 0; symbol < counts.size(); ++symbol) {
    if (counts[symbol] != 0) {
      rarest.push({counts[symbol], symbol});
    }
  }
  std::vector<std::size_t> parents(counts.size(), 0);
  while (rarest.size() > 1) {
    const Subtree first = rarest.top();
    rarest.pop();
    const Subtree second = rarest.top();
    rarest.pop();
    parents[first.number] = parents[second.number] = parents.size();
    rarest.push({first.count + second.count, parents.size()});
    parents.push_back(0);
  }
  std::vector<unsigned> result(parents.size(), 0);
  for (std::size_t i = parents.size() - 1; i-- > 0;) {
    result[i] = parents[i] == 0 ? 0 : result[parents[i]] + 1;
  }
  result.resize(counts.size());
  return result;
}

std::uint32_t reversed(std::uint32_t code, unsigned bits) {
  std::uint32_t result = 0;
  for (unsigned i = 0; i < bits; ++i) {
    result = (result << 1) | ((code >> i) & 1);
  }
  return result;
}

std::vector<std::uint32_t> canonical(const std::vector<unsigned>& lengths) {
  std::vector<std::uint32_t> codes(lengths.size(), 0);
  std::uint32_t next = 0;
  for (unsigned bits = 1; bits <= kMostBits; ++bits) {
    next <<= 1;
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] == bits) {
        codes[symbol] = reversed(next++, bits);
      }
    }
  }
  return codes;
}

}  // namespace

HuffmanCode huffman_code(std::vector<std::uint64_t> counts) {
  for (std::size_t i = 0; i < 2; ++i) {
    counts[i] = std::max<std::uint64_t>(counts[i], 1);
  }
  std::vector<unsigned> lengths = depths(counts);
  while (*std::max_element(lengths.begin(), lengths.end()) > kMostBits) {
    for (std::uint64_t& count : counts) {
      count = (count + 1) / 2;
    }
    lengths = depths(counts);
  }
  return {lengths, canonical(lengths)};
}

}  // namespace flashbvh::report
