// RFC 1950 (zlib) and RFC 1951 (deflate): repetitions, then Huffman codes for literals and lengths,
// and for distances.
//
// A library would do, but its next version may write other bytes; a page must not change with it.
#include "report/deflate.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "report/huffman.hpp"
#include "report/lz77.hpp"

namespace flashbvh::report {
namespace {

constexpr unsigned kEnd = 256;

/// A code and the bits that follow it.
struct Symbol {
  unsigned code;
  unsigned extra_bits;
  unsigned extra;
};

/// Codes for ever longer ranges: `group` codes for each number of extra bits.
Symbol symbol_of(unsigned value, unsigned group) {
  unsigned bits = 0;
  while ((value >> bits) >= 2 * group) {
    ++bits;
  }
  return {bits * group + (value >> bits), bits, value & ((1u << bits) - 1)};
}

Symbol length_symbol(unsigned length) {
  if (length == kMostMatch) {
    return {285, 0, 0};
  }
  Symbol symbol = symbol_of(length - kLeastMatch, 4);
  symbol.code += kEnd + 1;
  return symbol;
}

Symbol distance_symbol(unsigned distance) {
  return symbol_of(distance - 1, 2);
}

class BitWriter {
 public:
  void write(std::uint32_t value, unsigned bits) {
    pending_ |= std::uint64_t{value} << count_;
    for (count_ += bits; count_ >= 8; count_ -= 8) {
      bytes_ += static_cast<char>(pending_ & 0xFF);
      pending_ >>= 8;
    }
  }
  void write(const HuffmanCode& code, const Symbol& symbol) {
    write(code.codes[symbol.code], code.lengths[symbol.code]);
    write(symbol.extra, symbol.extra_bits);
  }
  std::string finish() {
    write(0, (8 - count_) % 8);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t pending_ = 0;
  unsigned count_ = 0;
};

constexpr std::size_t kLiteralCodes = 286;
constexpr std::size_t kDistanceCodes = 30;

/// The lengths of both codes, four bits each: the code of these lengths is the plain number.
void write_lengths(BitWriter& bits, const HuffmanCode& literals, const HuffmanCode& distances) {
  // The order in which RFC 1951 lists symbols of lengths: 16 to 18, which repeat, are not used.
  constexpr std::size_t listed = 19;
  bits.write(kLiteralCodes - 257, 5);
  bits.write(kDistanceCodes - 1, 5);
  bits.write(listed - 4, 4);
  for (std::size_t i = 0; i < listed; ++i) {
    bits.write(i < 3 ? 0 : 4, 3);
  }
  for (const HuffmanCode* const code : {&literals, &distances}) {
    for (const unsigned length : code->lengths) {
      unsigned reversed = 0;
      for (unsigned bit = 0; bit < 4; ++bit) {
        reversed |= ((length >> bit) & 1) << (3 - bit);
      }
      bits.write(reversed, 4);
    }
  }
}

std::string deflated(const std::vector<Token>& tokens) {
  std::vector<std::uint64_t> literal_counts(kLiteralCodes, 0);
  std::vector<std::uint64_t> distance_counts(kDistanceCodes, 0);
  literal_counts[kEnd] = 1;
  for (const Token& token : tokens) {
    ++literal_counts[token.length == 0 ? token.value : length_symbol(token.length).code];
    if (token.length != 0) {
      ++distance_counts[distance_symbol(token.value).code];
    }
  }
  const HuffmanCode literals = huffman_code(std::move(literal_counts));
  const HuffmanCode distances = huffman_code(std::move(distance_counts));
  BitWriter bits;
  bits.write(1 | 2 << 1, 3);  // the last block, with codes of its own
  write_lengths(bits, literals, distances);
  for (const Token& token : tokens) {
    bits.write(literals,
               token.length == 0 ? Symbol{token.value, 0, 0} : length_symbol(token.length));
    if (token.length != 0) {
      bits.write(distances, distance_symbol(token.value));
    }
  }
  bits.write(literals, {kEnd, 0, 0});
  return bits.finish();
}

std::uint32_t adler32(const std::string& bytes) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

}  // namespace

std::string zlib_stream(const std::string& bytes) {
  std::string stream = "\x78\x01" + deflated(tokens_of(bytes));
  const std::uint32_t sum = adler32(bytes);
  for (int shift = 24; shift >= 0; shift -= 8) {
    stream += static_cast<char>((sum >> shift) & 0xFF);
  }
  return stream;
}

}  // namespace flashbvh::report
