// Wavefront OBJ: `v` and `f` lines; what else may be there has no part in the shape.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "mesh/formats.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::array<std::string_view, 25> kNoShape = {
    "vt",     "vn",         "vp",        "g",      "o",     "s",        "mg",
    "usemtl", "mtllib",     "usemap",    "maplib", "bevel", "c_interp", "d_interp",
    "lod",    "shadow_obj", "trace_obj", "ctech",  "stech", "deg",      "vg",
    "call",   "csh",        "bmat",      "step"};

/// A line that ends with a backslash goes on in the next.
bool next_joined(Lines& lines, std::string& joined, std::size_t& number) {
  if (!lines.next_content()) {
    return false;
  }
  number = lines.number();
  joined = lines.line();
  while (!joined.empty() && joined.back() == '\\') {
    joined.back() = ' ';
    if (!lines.next()) {
      break;
    }
    joined += lines.line();
  }
  return true;
}

class ObjConverter {
 public:
  ObjConverter(std::string_view text, const std::string& file) : file_(file) {
    plain_.warning = warn_of_cut_line(text);
  }

  void line(const Words& words, std::size_t number) {
    const std::string_view keyword = words[0];
    if (keyword == "v") {
      vertex(words, number);
    } else if (keyword == "f" || keyword == "fo") {
      face(words, number);
    } else if (keyword == "p" || keyword == "l") {
      ++left_out_;
    } else if (std::find(kNoShape.begin(), kNoShape.end(), keyword) == kNoShape.end()) {
      throw UserError(
          at_line(file_, number), quoted(keyword),
          " is no vertex, polygon or attribute of OBJ; export the mesh again, as polygons");
    }
  }

  MeshText finish() {
    if (plain_.face_count == 0) {
      throw UserError(file_, "has no polygons; export the mesh again");
    }
    if (left_out_ != 0) {
      plain_.warning +=
          concat((plain_.warning.empty() ? "" : "; "), left_out_, " points or lines left out");
    }
    return std::move(plain_);
  }

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
    plain_.bytes += "v";
    for (std::size_t axis = 1; axis <= 3; ++axis) {
      append_coordinate(plain_.bytes, words[axis], file_, number);
    }
    plain_.bytes += "\n";
    ++vertex_count_;
  }

  void face(const Words& words, std::size_t number) {
    if (words.size() < 4) {
      throw UserError(at_line(file_, number), "a polygon of ", words.size() - 1,
                      " corners; it must have three or more");
    }
    plain_.bytes += "f";
    for (std::size_t i = 1; i < words.size(); ++i) {
      plain_.bytes += concat(" ", vertex_number(words[i], number));
    }
    plain_.bytes += "\n";
    ++plain_.face_count;
  }

  /// Of "12", "12/3", "12//4" or "12/3/4"; negative numbers count back from the last vertex.
  long long vertex_number(std::string_view corner, std::size_t number) const {
    const auto index = parse_integer(corner.substr(0, corner.find('/')));
    const long long at = !index ? 0 : *index < 0 ? vertex_count_ + 1 + *index : *index;
    if (at < 1 || at > vertex_count_) {
      throw UserError(at_line(file_, number), "a corner at vertex ", quoted(corner),
                      ", but there are ", vertex_count_, " vertices so far; export the mesh again");
    }
    return at;
  }

  const std::string& file_;
  MeshText plain_;
  long long vertex_count_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace

// By value, as all its kin: one table holds them.
// NOLINTNEXTLINE(performance-unnecessary-value-param)
MeshText plain_obj(std::string bytes, const std::string& file) {
  Lines lines(bytes);
  ObjConverter converter(bytes, file);
  std::string joined;
  for (std::size_t number = 0; next_joined(lines, joined, number);) {
    const Words words = words_of(joined);
    if (!words.empty()) {
      converter.line(words, number);
    }
  }
  return converter.finish();
}

}  // namespace flashbvh::tool
