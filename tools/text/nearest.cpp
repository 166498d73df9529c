#include "text/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "text/numbers.hpp"

namespace flashbvh::tool {

std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> edits(b.size() + 1);  // from the read part of a to each prefix of b
  std::iota(edits.begin(), edits.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(edits[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = edits[j + 1];
      edits[j + 1] = std::min({replaced, edits[j] + 1, diagonal + 1});
    }
  }
  return edits.back();
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t fewest = std::min((word.size() + 2) / 3 + 1, word.size());
  for (const std::string& candidate : words) {
    const bool is_begun = word.size() >= 2 && candidate.compare(0, word.size(), word) == 0;
    const std::size_t edits =
        std::min(edits_between(word, candidate), is_begun ? std::size_t{1} : fewest);
    if (edits < fewest) {
      fewest = edits;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string nearest_hint(std::string_view word, const std::vector<std::string>& words,
                         const char* before) {
  const std::string nearest = nearest_word(word, words);
  return nearest.empty() ? "" : concat("; the nearest is '", before, nearest, "'");
}

}  // namespace flashbvh::tool
