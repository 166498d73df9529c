// Ziv and Lempel, "A Universal Algorithm for Sequential Data Compression", 1977, over chains of
// earlier places with the same three bytes.
#include "report/lz77.hpp"

#include <algorithm>

namespace flashbvh::report {
namespace {

constexpr int kMostTries = 64;

/// Finds earlier places that begin with the same bytes.
class Matches {
 public:
  explicit Matches(const std::string& bytes)
      : bytes_(bytes), latest_(1u << kHashBits, kNone), earlier_(bytes.size(), kNone) {}

  /// The longest match at `place`; length 0 if there is none.
  Token longest(std::size_t place) const {
    Token best = {0, 0};
    if (place + kLeastMatch > bytes_.size()) {
      return best;
    }
    std::uint32_t candidate = latest_[hash(place)];
    for (int tries = 0; tries < kMostTries && candidate != kNone; ++tries) {
      if (place - candidate >= kWindow) {
        break;
      }
      const std::size_t length = common_length(candidate, place);
      if (length >= kLeastMatch && length > best.length) {
        best = {static_cast<std::uint16_t>(length), static_cast<std::uint16_t>(place - candidate)};
      }
      candidate = earlier_[candidate];
    }
    return best;
  }

  void add(std::size_t place) {
    if (place + kLeastMatch <= bytes_.size()) {
      std::uint32_t& latest = latest_[hash(place)];
      earlier_[place] = latest;
      latest = static_cast<std::uint32_t>(place);
    }
  }

 private:
  static constexpr unsigned kHashBits = 15;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  std::uint32_t byte(std::size_t place) const { return static_cast<std::uint8_t>(bytes_[place]); }
  std::size_t hash(std::size_t place) const {
    const std::uint32_t three = byte(place) | byte(place + 1) << 8 | byte(place + 2) << 16;
    return (three * 0x9E3779B1u) >> (32 - kHashBits);
  }
  std::size_t common_length(std::size_t p, std::size_t q) const {
    const std::size_t most = std::min<std::size_t>(kMostMatch, bytes_.size() - q);
    std::size_t length = 0;
    while (length < most && bytes_[p + length] == bytes_[q + length]) {
      ++length;
    }
    return length;
  }

  const std::string& bytes_;
  std::vector<std::uint32_t> latest_;   ///< by hash
  std::vector<std::uint32_t> earlier_;  ///< by place: the one before with the same hash
};

}  // namespace

std::vector<Token> tokens_of(const std::string& bytes) {
  Matches matches(bytes);
  std::vector<Token> tokens;
  for (std::size_t place = 0; place < bytes.size();) {
    Token token = matches.longest(place);
    if (token.length == 0) {
      token.value = static_cast<std::uint8_t>(bytes[place]);
    }
    tokens.push_back(token);
    for (std::size_t end = place + std::max<std::size_t>(token.length, 1); place < end; ++place) {
      matches.add(place);
    }
  }
  return tokens;
}

}  // namespace flashbvh::report
