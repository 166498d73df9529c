// Compression in the format of zlib, for the pictures of a page.
#ifndef FLASHBVH_TOOLS_REPORT_DEFLATE_HPP
#define FLASHBVH_TOOLS_REPORT_DEFLATE_HPP

#include <string>

namespace flashbvh::report {

/// A zlib stream that holds `bytes`, the same on every machine. Matches of up to 258 bytes within
/// 32 KiB, one block, Huffman codes of its own.
std::string zlib_stream(const std::string& bytes);

}  // namespace flashbvh::report

#endif
