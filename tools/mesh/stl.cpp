// STL: binary (80 bytes, a count, 50 bytes a triangle) and ASCII.
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "mesh/formats.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::size_t kHeader = 84;
constexpr std::size_t kPerTriangle = 50;

std::size_t binary_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
  return count;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= kHeader && bytes.size() == kHeader + kPerTriangle * binary_count(bytes);
}

/// Binary files may begin with "solid", too; then they hold bytes that text does not.
bool looks_like_ascii(std::string_view bytes) {
  const std::vector<std::string_view> words = words_of(bytes.substr(0, bytes.find('\n')));
  constexpr std::string_view kNul("\0", 1);
  return !words.empty() && words[0].size() == 5 && (words[0] == "solid" || words[0] == "SOLID") &&
         bytes.find(kNul) == std::string_view::npos;
}

[[noreturn]] void refuse_binary(std::string_view bytes, const std::string& file) {
  if (bytes.size() < kHeader) {
    throw UserError(file, "is no STL file (too short); export the mesh again");
  }
  const std::size_t count = binary_count(bytes);
  throw UserError(file, "is truncated or no STL file: its header announces ", count,
                  " triangles, which take ", kHeader + kPerTriangle * count, " bytes, but it has ",
                  bytes.size(), "; export the mesh again");
}

std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

/// The words of an ASCII file in turn, each with its line.
class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  /// An empty word at the end of the file.
  std::string word() {
    while (at_ == words_.size()) {
      if (!lines_.next()) {
        return {};
      }
      words_ = words_of(lines_.line());
      at_ = 0;
    }
    return lower(words_[at_++]);
  }
  std::size_t line() const { return lines_.number(); }
  const std::string& file() const { return file_; }
  void skip_line() { at_ = words_.size(); }
  void expect(const char* wanted) {
    const std::string found = word();
    if (found != wanted) {
      refuse(wanted, found);
    }
  }
  [[noreturn]] void refuse(const std::string& wanted, const std::string& found) const {
    const std::string what = found.empty() ? "the file ends" : "'" + found.substr(0, 40) + "' is";
    throw UserError(at_line(file_, lines_.number()), what, " where '", wanted,
                    "' must be; export the mesh again");
  }

 private:
  Lines lines_;
  const std::string& file_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

void copy_facet(Reader& reader, std::string& plain) {
  reader.expect("normal");
  for (int i = 0; i < 3; ++i) {
    reader.word();  // recomputed by nobody: the tree needs none
  }
  reader.expect("outer");
  reader.expect("loop");
  plain += "facet normal 0 0 0\nouter loop\n";
  for (int corner = 0; corner < 3; ++corner) {
    reader.expect("vertex");
    plain += "vertex";
    for (int axis = 0; axis < 3; ++axis) {
      const std::string word = reader.word();
      append_coordinate(plain, word, reader.file(), reader.line());
    }
    plain += "\n";
  }
  reader.expect("endloop");
  reader.expect("endfacet");
  plain += "endloop\nendfacet\n";
}

MeshText plain_ascii(std::string_view text, const std::string& file) {
  MeshText plain;
  plain.bytes = "solid\n";
  Reader reader(text, file);
  for (std::string word = reader.word(); !word.empty(); word = reader.word()) {
    if (word != "solid") {
      reader.refuse("solid", word);
    }
    reader.skip_line();
    for (word = reader.word(); word == "facet"; word = reader.word()) {
      copy_facet(reader, plain.bytes);
      ++plain.face_count;
    }
    if (word != "endsolid") {
      reader.refuse("endsolid", word);
    }
    reader.skip_line();
  }
  plain.bytes += "endsolid\n";
  return plain;
}

}  // namespace

MeshText plain_stl(std::string bytes, const std::string& file) {
  MeshText plain;
  if (is_binary(bytes)) {
    plain.face_count = binary_count(bytes);
    plain.bytes = std::move(bytes);
  } else if (looks_like_ascii(bytes)) {
    plain = plain_ascii(bytes, file);
  } else {
    refuse_binary(bytes, file);
  }
  if (plain.face_count == 0) {
    throw UserError(file, "has no triangles; export the mesh again");
  }
  return plain;
}

}  // namespace flashbvh::tool
