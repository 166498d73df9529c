// STL: binary (80 bytes, a count, 50 bytes per triangle) and ASCII.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::uint64_t kHeader = 84;
constexpr std::uint64_t kPerTriangle = 50;

std::size_t binary_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kPerTriangle * binary_count(bytes);
}

/// A binary file has NULs in its header or its count, which no file of 4 GiB fills.
bool looks_like_ascii(std::string_view bytes) {
  constexpr std::string_view kNul("\0", 1);
  return without_padding(bytes).substr(0, kHeader).find(kNul) == std::string_view::npos;
}

/// Bytes behind the last triangle of a binary file, as a warning. UserError if they are too few or
/// may be triangles.
std::string refuse_other_size(std::string_view bytes, const std::string& file) {
  const std::size_t count = bytes.size() < kHeader ? 0 : binary_count(bytes);
  const std::uint64_t wanted = kHeader + kPerTriangle * count;
  if (bytes.size() < wanted) {
    throw UserError(file,
                    "is truncated or no STL file: it is no text that begins with 'solid', and ",
                    count, " triangles, as its header announces, take ", wanted,
                    " bytes, but it has ", bytes.size(), "; export the mesh again");
  }
  const std::uint64_t behind = bytes.size() - wanted;
  if (behind >= kPerTriangle &&
      !without_padding(bytes.substr(static_cast<std::size_t>(wanted))).empty()) {
    throw UserError(file, "its header announces ", count, " triangles, but ", behind,
                    " bytes follow them, which ", behind / kPerTriangle,
                    " more would fill; export the mesh again");
  }
  return concat(behind, " bytes behind the last triangle left out");
}

/// Reads the words of an ASCII file in turn, each with its line.
class AsciiReader {
 public:
  AsciiReader(std::string_view text, const std::string& file)
      : lines_(text), file_(file), builder_(file) {}

  FileMesh read() {
    for (std::string word = lower_case(next()); !word.empty(); word = lower_case(next())) {
      if (word != "solid") {
        refuse("solid", word);
      }
      skip_name();
      for (word = lower_case(next()); word == "facet"; word = lower_case(next())) {
        facet();
      }
      if (word != "endsolid") {
        refuse("endsolid", word);
      }
      skip_name();
    }
    return builder_.finish();
  }

 private:
  /// The next word; empty at the end of the file. Skips lines of comments.
  std::string_view next() {
    while (at_ == words_.size()) {
      if (!lines_.next()) {
        return {};
      }
      words_ = words_of(lines_.line());
      at_ = words_.empty() || words_[0][0] != '#' ? 0 : words_.size();
    }
    return words_[at_++];
  }

  /// Skips the rest of the line: a name, no triangle.
  void skip_name() {
    for (; at_ < words_.size(); ++at_) {
      if (lower_case(words_[at_]) == "endloop") {
        throw UserError(at_line(file_, lines_.number()),
                        "a triangle on the line of a solid's name; give it lines of its own");
      }
    }
  }

  void facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) {
      next();  // the normal, which the tree does not need
    }
    expect("outer");
    expect("loop");
    std::array<Position, 3> corners{};
    for (Position& corner : corners) {
      expect("vertex");
      for (double& at : corner) {
        const std::string_view word = next();
        at = coordinate(word, file_, lines_.number());
      }
    }
    expect("endloop");
    expect("endfacet");
    builder_.add_triangle(corners);
  }

  void expect(const char* wanted) {
    const std::string_view found = next();
    if (lower_case(found) != wanted) {
      refuse(wanted, found);
    }
  }

  [[noreturn]] void refuse(const char* wanted, std::string_view found) const {
    throw UserError(at_line(file_, lines_.number()),
                    found.empty() ? "the file ends" : quoted(found) + " is", " where '", wanted,
                    "' must be; export the mesh again");
  }

  Lines lines_;
  const std::string& file_;
  MeshBuilder builder_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

FileMesh read_binary(std::string_view bytes, const std::string& file) {
  MeshBuilder builder(file);
  const std::size_t count = binary_count(bytes);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::array<float, 3>, 4> facet{};  // the normal comes first
    std::memcpy(&facet, bytes.data() + kHeader + kPerTriangle * i, sizeof facet);
    std::array<Position, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::copy(facet[corner + 1].begin(), facet[corner + 1].end(), corners[corner].begin());
      if (!std::all_of(corners[corner].begin(), corners[corner].end(), is_coordinate)) {
        throw UserError(file, "polygon ", i,
                        " (from 0) has a coordinate that is no finite number; repair the mesh");
      }
    }
    builder.add_triangle(corners);
  }
  return builder.finish();
}

}  // namespace

FileMesh read_stl(std::string_view bytes, const std::string& file) {
  if (is_binary(bytes)) {
    return read_binary(bytes, file);
  }
  refuse_other_contents(bytes, file);
  if (!looks_like_ascii(bytes)) {
    const std::string warning = refuse_other_size(bytes, file);
    FileMesh mesh = read_binary(bytes, file);
    mesh.warnings.push_back(warning);
    return mesh;
  }
  return AsciiReader(without_padding(bytes), file).read();
}

}  // namespace flashbvh::tool
