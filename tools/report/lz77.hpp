// Repetitions in a run of bytes.
#ifndef FLASHBVH_TOOLS_REPORT_LZ77_HPP
#define FLASHBVH_TOOLS_REPORT_LZ77_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::report {

/// What deflate can say of a repetition.
constexpr unsigned kLeastMatch = 3;
constexpr unsigned kMostMatch = 258;
constexpr std::size_t kWindow = 32768;

/// A literal byte, or `length` bytes from `distance` before.
struct Token {
  std::uint16_t length;  ///< 0: a literal
  std::uint16_t value;   ///< the literal, or the distance
};

/// What the bytes are made of: the longest repetitions that are found at each place, from the first
/// on.
std::vector<Token> tokens_of(const std::string& bytes);

}  // namespace flashbvh::report

#endif
