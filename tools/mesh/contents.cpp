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

constexpr std::array<Content, 7> kContents = {{
    {"version https://git-lfs", "is a pointer of Git LFS; fetch the file by 'git lfs pull'"},
    {"\x1F\x8B", "is compressed by gzip; unpack it"},
    {"PK\x03\x04", kZip, "3mf"},
    {"\xFF\xFE", kUtf16},
    {"\xFE\xFF", kUtf16},
    {"glTF", "is a GLB file; name it .glb", "glb"},
    {"<", "is XML or a page of the web; download the file itself, or name it by its format", "dae"},
}};

}  // namespace

void refuse_other_contents(std::string_view bytes, const std::string& file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  for (const Content& content : kContents) {
    if (bytes.substr(0, content.first.size()) == content.first &&
        (content.right.empty() || extension != concat(".", content.right))) {
      throw UserError(file, content.what);
    }
  }
}

std::string_view without_padding(std::string_view text) {
  constexpr std::string_view kPadding("\0\x1A", 2);
  const std::size_t last = text.find_last_not_of(kPadding);
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace flashbvh::tool
