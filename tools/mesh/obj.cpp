// Wavefront OBJ: reads `v` and `f` lines; others do not affect the shape.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

/// Not `call` and `csh`, which add what another file or a program writes.
constexpr std::array<std::string_view, 23> kNoShape = {
    "o",         "g",      "vt",     "vn",    "vp",       "s",        "mg",  "usemtl",
    "mtllib",    "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj",
    "trace_obj", "ctech",  "stech",  "deg",   "vg",       "bmat",     "step"};

std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

/// Joins a line that ends with a backslash with the next one.
bool next_joined(Lines& lines, std::string& joined, std::size_t& number) {
  if (!lines.next()) {
    return false;
  }
  number = lines.number();
  joined = without_comment(lines.line());
  while (!joined.empty() && joined.back() == '\\') {
    joined.back() = ' ';
    if (!lines.next()) {
      break;
    }
    joined += lines.line();
  }
  return true;
}

class ObjReader {
 public:
  explicit ObjReader(const std::string& file) : file_(file), builder_(file) {}

  void line(const Words& words, std::size_t number) {
    const std::string_view keyword = words[0];
    if (keyword == "v") {
      vertex(words, number);
    } else if (keyword == "f" || keyword == "fo") {
      face(words, number);
    } else if (keyword == "p" || keyword == "l") {
      builder_.leave_out();
    } else if (std::find(kNoShape.begin(), kNoShape.end(), keyword) == kNoShape.end()) {
      throw UserError(
          at_line(file_, number), quoted(keyword),
          " is no vertex, polygon or attribute of OBJ; export the mesh again, as polygons");
    }
  }

  FileMesh finish() { return builder_.finish(); }

 private:
  void vertex(const Words& words, std::size_t number) {
    const std::size_t count = words.size() - 1;  // a weight may follow, or three or four of colour
    if (count != 3 && count != 4 && count != 6 && count != 7) {
      throw UserError(at_line(file_, number), "a vertex of ", count,
                      " coordinates; it must have three");
    }
    if (count == 4 && parse_number(words[4]) != 1.0) {
      throw UserError(at_line(file_, number),
                      "a vertex with a weight; export the mesh as polygons");
    }
    builder_.add_point({coordinate(words[1], file_, number), coordinate(words[2], file_, number),
                        coordinate(words[3], file_, number)});
  }

  void face(const Words& words, std::size_t number) {
    if (words.size() < 4) {
      throw UserError(at_line(file_, number), "a polygon of ", words.size() - 1,
                      " corners; it must have three or more");
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 1; i < words.size(); ++i) {
      corners.push_back(point(words[i], number));
    }
    builder_.add_polygon(corners);
  }

  /// The point of "12", "12/3", "12//4" or "12/3/4"; negative numbers count from the last vertex.
  std::uint32_t point(std::string_view corner, std::size_t number) const {
    const auto count = static_cast<long long>(builder_.point_count());
    const auto index = parse_integer(corner.substr(0, corner.find('/')));
    const long long at = !index ? 0 : *index < 0 ? count + 1 + *index : *index;
    if (at < 1 || at > count) {
      throw UserError(at_line(file_, number), "a corner at vertex ", quoted(corner),
                      ", but there are ", count, " vertices so far; export the mesh again");
    }
    return static_cast<std::uint32_t>(at - 1);
  }

  const std::string& file_;
  MeshBuilder builder_;
};

}  // namespace

FileMesh read_obj(std::string_view bytes, const std::string& file) {
  refuse_other_contents(bytes, file);
  bytes = without_padding(bytes);
  Lines lines(bytes);
  ObjReader reader(file);
  std::string joined;
  for (std::size_t number = 0; next_joined(lines, joined, number);) {
    const Words words = words_of(joined);
    if (!words.empty()) {
      reader.line(words, number);
    }
  }
  FileMesh mesh = reader.finish();
  warn_of_cut_line(bytes, mesh);
  return mesh;
}

}  // namespace flashbvh::tool
