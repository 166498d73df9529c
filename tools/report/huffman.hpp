// Huffman codes as deflate wants them: canonical, of at most 15 bits.
#ifndef FLASHBVH_TOOLS_REPORT_HUFFMAN_HPP
#define FLASHBVH_TOOLS_REPORT_HUFFMAN_HPP

#include <cstdint>
#include <vector>

namespace flashbvh::report {

struct HuffmanCode {
  std::vector<unsigned> lengths;     ///< in bits; 0 for a symbol that does not occur
  std::vector<std::uint32_t> codes;  ///< first bit of the code in bit 0
};

/// For symbols that occur this often. At least two symbols get a code, whatever occurs.
HuffmanCode huffman_code(std::vector<std::uint64_t> counts);

}  // namespace flashbvh::report

#endif
