// OFF: a header, counts, a line a vertex, a line a polygon.
#include <array>
#include <string_view>
#include <vector>

#include "mesh/formats.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

/// assimp leaves out larger ones.
constexpr long long kMostCorners = 9;

struct Counts {
  long long vertices = 0;
  long long faces = 0;
};

class OffConverter {
 public:
  OffConverter(std::string_view text, const std::string& file) : lines_(text), file_(file) {
    plain_.warning = warn_of_cut_line(text);
  }

  MeshText convert() {
    const Counts counts = header();
    if (counts.faces == 0) {
      throw UserError(file_, "has no polygons; export the mesh again");
    }
    plain_.bytes = concat("OFF\n", counts.vertices, " ", counts.faces, " 0\n");
    for (long long i = 0; i < counts.vertices; ++i) {
      vertex(next("vertex", i, counts.vertices));
    }
    for (long long i = 0; i < counts.faces; ++i) {
      face(next("polygon", i, counts.faces), counts);
    }
    if (lines_.next_content()) {
      refuse("there is more than the header announces; export the mesh again");
    }
    plain_.face_count = static_cast<std::size_t>(counts.faces);
    return std::move(plain_);
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
    for (std::size_t axis = 0; axis < 3; ++axis) {
      append_coordinate(plain_.bytes, words[axis], file_, lines_.number());
    }
    plain_.bytes += "\n";
  }

  void face(const Words& words, const Counts& counts) {
    const long long corners = parse_integer(words[0]).value_or(0);
    if (corners < 3 || corners > kMostCorners) {
      refuse("a polygon of ", quoted(words[0]),
             " corners; it must have 3 to 9: triangulate the mesh");
    }
    if (words.size() < static_cast<std::size_t>(corners) + 1) {
      refuse("a polygon of ", corners, " corners names only ", words.size() - 1,
             "; export the mesh again");
    }
    plain_.bytes += words[0];
    for (std::size_t i = 1; i <= static_cast<std::size_t>(corners); ++i) {
      const long long at = parse_integer(words[i]).value_or(-1);
      if (at < 0 || at >= counts.vertices) {
        refuse("a corner at vertex ", quoted(words[i]), ", but there are ", counts.vertices,
               " vertices; export the mesh again");
      }
      plain_.bytes += concat(" ", at);
    }
    plain_.bytes += "\n";
  }

  Lines lines_;
  const std::string& file_;
  MeshText plain_;
};

}  // namespace

// By value, as all its kin: one table holds them.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
MeshText plain_off(std::string bytes, const std::string& file) {
  return OffConverter(bytes, file).convert();
}

}  // namespace flashbvh::tool
