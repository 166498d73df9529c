#include "text/messages.hpp"

#include <algorithm>
#include <iostream>

namespace flashbvh::tool {
namespace {

constexpr std::size_t kShown = 5;

}  // namespace

std::string one_line(std::string text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  while (!text.empty() && is_control(text.back())) {
    text.pop_back();
  }
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  return text;
}

std::string triangle_list(const std::vector<std::uint32_t>& triangles) {
  const std::size_t count = triangles.size();
  const std::size_t shown = std::min(count, kShown);
  std::string text = concat(count, (count == 1 ? " triangle (" : " triangles ("));
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == count && i != 0;
    text += concat((i == 0 ? "" : last ? " and " : ", "), triangles[i]);
  }
  return text + (shown == count ? ")" : concat(" and ", count - shown, " more)"));
}

std::string at_line(const std::string& file, std::size_t line) {
  return concat(file, ":", line);
}

std::string quoted(std::string_view word) {
  return concat("'", word.substr(0, 40), "'");
}

double number_of(std::string_view word, const std::string& place, const char* more) {
  const auto number = parse_number(word);
  if (!number) {
    throw UserError(place, quoted(word), " is no finite number", more);
  }
  return *number;
}

void flush_output() {
  if (!std::cout.flush()) {
    throw std::runtime_error("standard output can't be written");
  }
}

void Warnings::add(const std::string& place, const std::string& what) {
  all_.push_back({place, what});
}

void Warnings::print() const {
  for (const PlacedWarning& warning : all_) {
    std::cerr << "flashbvh: " << one_line(warning.place + ": warning: " + warning.what) << "\n";
  }
}

}  // namespace flashbvh::tool
