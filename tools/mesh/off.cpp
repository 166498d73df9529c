// OFF: a header, counts, one line per vertex, one line per polygon.
#include <cstdint>
#include <string_view>
#include <vector>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

struct Counts {
  long long vertices = 0;
  long long faces = 0;
};

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& file)
      : lines_(text), file_(file), builder_(file) {}

  FileMesh read() {
    const Counts counts = header();
    for (long long i = 0; i < counts.vertices; ++i) {
      vertex(next("vertex", i, counts.vertices));
    }
    for (long long i = 0; i < counts.faces; ++i) {
      face(next("polygon", i, counts.faces), counts);
    }
    if (lines_.next_content()) {
      refuse("there is more than the header announces; export the mesh again");
    }
    return builder_.finish();
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(at_line(file_, lines_.number()), what...);
  }

  /// The keyword may be missing, and the counts may stand on its line.
  Counts header() {
    Words words = lines_.next_content() ? words_of(lines_.line()) : Words();
    if (!words.empty() && (words[0] == "OFF" || words[0] == "COFF" || words[0] == "NOFF" ||
                           words[0] == "CNOFF" || words[0] == "STOFF")) {
      words.erase(words.begin());
      if (words.empty() && lines_.next_content()) {
        words = words_of(lines_.line());
      }
    }
    const auto vertices = words.size() < 2 ? std::nullopt : parse_integer(words[0]);
    const auto faces = words.size() < 2 ? std::nullopt : parse_integer(words[1]);
    if (!vertices || !faces || *vertices < 0 || *faces < 0) {
      refuse("is no OFF file: 'OFF' and the numbers of vertices and polygons must be here");
    }
    return {*vertices, *faces};
  }

  Words next(const char* kind, long long index, long long count) {
    if (!lines_.next_content()) {
      refuse("the file ends at ", kind, " ", index, " of ", count, "; export the mesh again");
    }
    return words_of(lines_.line());
  }

  void vertex(const Words& words) {
    if (words.size() < 3) {
      refuse("a vertex of ", words.size(), " coordinates; it must have three");
    }
    const std::size_t line = lines_.number();
    builder_.add_point({coordinate(words[0], file_, line), coordinate(words[1], file_, line),
                        coordinate(words[2], file_, line)});
  }

  void face(const Words& words, const Counts& counts) {
    const long long corners = parse_integer(words[0]).value_or(0);
    if (corners < 3) {
      refuse("a polygon of ", quoted(words[0]), " corners; it must have three or more");
    }
    if (words.size() - 1 < static_cast<std::size_t>(corners)) {
      refuse("a polygon of ", corners, " corners names only ", words.size() - 1,
             "; export the mesh again");
    }
    corners_.clear();
    for (std::size_t i = 1; i <= static_cast<std::size_t>(corners); ++i) {
      const long long at = parse_integer(words[i]).value_or(-1);
      if (at < 0 || at >= counts.vertices) {
        refuse("a corner at vertex ", quoted(words[i]), ", but there are ", counts.vertices,
               " vertices; export the mesh again");
      }
      corners_.push_back(static_cast<std::uint32_t>(at));
    }
    builder_.add_polygon(corners_);
  }

  Lines lines_;
  const std::string& file_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

FileMesh read_off(std::string_view bytes, const std::string& file) {
  FileMesh mesh = OffReader(bytes, file).read();
  warn_of_cut_line(bytes, mesh);
  return mesh;
}

}  // namespace flashbvh::tool
