// Refuses files whose first bytes show that they hold something else than their name says.
#include <array>
#include <filesystem>
#include <string_view>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

struct Content {
  std::string_view first;  ///< bytes
  const char* what;
  std::string_view right = {};  ///< the extension of files that these bytes begin
};

constexpr const char* kUtf16 = "is text in UTF-16; save it as UTF-8";
constexpr const char* kZip = "is a zip archive; unpack it, or name it .3mf if it is one";

constexpr std::array<Content, 10> kContents = {{
    {"version https://git-lfs", "is a pointer of Git LFS; fetch the file by 'git lfs pull'"},
    {"\x1F\x8B", "is compressed by gzip; unpack it"},
    {"PK\x03\x04", kZip, "3mf"},
    {"\xFF\xFE", kUtf16},
    {"\xFE\xFF", kUtf16},
    {"glTF", "is a GLB file; name it .glb", "glb"},
    {"<!DOCTYPE html", "is a page of the web; download the file itself"},
    {"<!doctype html", "is a page of the web; download the file itself"},
    {"<html", "is a page of the web; download the file itself"},
    {"<?xml", "is XML; name it by its format", "dae"},
}};

/// Text in UTF-16 without a byte order mark.
bool has_wide_letters(std::string_view bytes) {
  const auto is_nul = [&](std::size_t i) { return bytes[i] == 0; };
  return bytes.size() >= 4 && is_nul(0) != is_nul(1) && is_nul(0) == is_nul(2) &&
         is_nul(1) == is_nul(3);
}

}  // namespace

void refuse_other_contents(std::string_view bytes, const std::string& file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  for (const Content& content : kContents) {
    if (bytes.substr(0, content.first.size()) == content.first &&
        (content.right.empty() || extension != concat(".", content.right))) {
      throw UserError(file, content.what);
    }
  }
  if (has_wide_letters(bytes)) {
    throw UserError(file, kUtf16);
  }
}

std::string_view without_padding(std::string_view text) {
  constexpr std::string_view kPadding("\0\x1A", 2);
  const std::size_t last = text.find_last_not_of(kPadding);
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace flashbvh::tool
