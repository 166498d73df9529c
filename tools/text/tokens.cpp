#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r\n";

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t at = line.find_first_not_of(kBlanks);
  while (at != std::string_view::npos) {
    const std::size_t end = line.find_first_of(kBlanks, at);
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

bool Lines::next() {
  if (rest_.empty()) {
    return false;
  }
  const std::size_t end = rest_.find_first_of("\r\n");
  line_ = rest_.substr(0, end);
  if (end == std::string_view::npos) {
    rest_ = {};
  } else {
    rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  ++number_;
  return true;
}

bool Lines::next_content() {
  while (next()) {
    line_ = line_.substr(0, line_.find('#'));
    if (line_.find_first_not_of(kBlanks) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace flashbvh::tool
