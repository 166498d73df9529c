// PLY: a header of elements and their properties, then the elements, as text or binary. Vertices
// and faces make the mesh. Other elements and properties are read only to check that the file has
// all that its header announces.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "mesh/mesh_builder.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Words = std::vector<std::string_view>;

/// The type of a number.
struct Type {
  std::string_view name;
  std::string_view other_name;
  bool is_floating;
  std::size_t size;              ///< in bytes
  double (*value)(const char*);  ///< of these bytes, the least first
};

template <class Number>
constexpr Type type_of(std::string_view name, std::string_view other_name) {
  return {name, other_name, std::is_floating_point_v<Number>, sizeof(Number),
          [](const char* bytes) {
            Number number{};
            std::memcpy(&number, bytes, sizeof number);
            return static_cast<double>(number);
          }};
}

constexpr std::array<Type, 8> kTypes = {
    {type_of<std::int8_t>("char", "int8"), type_of<std::uint8_t>("uchar", "uint8"),
     type_of<std::int16_t>("short", "int16"), type_of<std::uint16_t>("ushort", "uint16"),
     type_of<std::int32_t>("int", "int32"), type_of<std::uint32_t>("uint", "uint32"),
     type_of<float>("float", "float32"), type_of<double>("double", "float64")}};

struct Property {
  /// What it gives the mesh: a vertex's coordinate, or a polygon's corners.
  enum Role { x, y, z, corners, other };

  std::string_view name;
  Type value;
  std::optional<Type> length;  ///< of a list's length
  Role role;
};

struct Element {
  std::string_view name;
  long long count;
  std::vector<Property> properties;
};

/// Element and property names are unique where they belong.
struct Header {
  std::string_view format;  ///< of the numbers; never empty after reading
  std::vector<Element> elements;
  std::string_view body;  ///< all that follows the header
};

template <class Named>
const Named* find(const std::vector<Named>& all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Property::Role role_of(const Property& property, std::string_view element) {
  const std::string_view name = property.name;
  if (element == "vertex" && !property.length && name.size() == 1) {
    return static_cast<Property::Role>(
        std::min(std::string_view("xyz").find(name), std::size_t{Property::other}));
  }
  const bool is_corners = element == "face" && property.length && !property.value.is_floating &&
                          (name == "vertex_indices" || name == "vertex_index");
  return is_corners ? Property::corners : Property::other;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  Header read() {
    if (!lines_.next() || words_of(lines_.line()) != Words{"ply"}) {
      throw UserError(file_, "is no PLY file: it does not begin with 'ply'");
    }
    while (lines_.next()) {
      const Words words = words_of(lines_.line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
        continue;
      }
      if (words[0] == "end_header") {
        need(!header_.format.empty(), "the header ends without a 'format'");
        header_.body = lines_.rest();
        return std::move(header_);
      }
      line(words);
    }
    need(false, "the file ends in its header");
    return {};
  }

 private:
  template <class... Parts>
  void need(bool is_so, const Parts&... what) const {
    if (!is_so) {
      throw UserError(at_line(file_, lines_.number()), what..., "; export the mesh again");
    }
  }

  void line(const Words& words) {
    if (words[0] == "format" && words.size() == 3 && header_.format.empty()) {
      header_.format = words[1];
      need(words[1] == "ascii" || words[1] == "binary_little_endian" ||
               words[1] == "binary_big_endian",
           "no format of PLY");
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = parse_integer(words[2]);
      need(count && *count >= 0, "an element without a count");
      need(find(header_.elements, words[1]) == nullptr, "a second element ", quoted(words[1]));
      header_.elements.push_back({words[1], *count, {}});
    } else if (words[0] == "property" && !header_.elements.empty()) {
      property(words);
    } else {
      need(false, "no line of a PLY header");
    }
  }

  void property(const Words& words) {
    const bool is_list = words.size() == 5 && words[1] == "list";
    need(words.size() == 3 || is_list, "no property of PLY");
    Element& element = header_.elements.back();
    need(find(element.properties, words.back()) == nullptr, "a second property ",
         quoted(words.back()));
    Property made = {words.back(), type(words[words.size() - 2]), {}, Property::other};
    if (is_list) {
      made.length = type(words[2]);
      need(!made.length->is_floating, "a list whose length is no integer");
    }
    made.role = role_of(made, element.name);
    element.properties.push_back(made);
  }

  Type type(std::string_view name) const {
    const auto* const found = std::find_if(kTypes.begin(), kTypes.end(), [&](const Type& type) {
      return type.name == name || type.other_name == name;
    });
    need(found != kTypes.end(), "no type of PLY");
    return *found;
  }

  Lines lines_;
  const std::string& file_;
  Header header_;
};

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& file)
      : file_(file),
        header_(HeaderReader(text, file).read()),
        rest_(header_.body),
        builder_(file) {}

  FileMesh read() {
    check_header();
    for (const Element& element : header_.elements) {
      element_ = &element;
      for (number_ = 0; number_ < element.count; ++number_) {
        read_element();
      }
    }
    if (without_padding(rest_).find_first_not_of(kBlanks) != std::string_view::npos) {
      throw UserError(file_, "has more than its header announces; export the mesh again");
    }
    for (const std::vector<std::uint32_t>& polygon : polygons_) {
      builder_.add_polygon(polygon);
    }
    FileMesh mesh = builder_.finish();
    if (is_text()) {
      warn_of_cut_line(without_padding(header_.body), mesh);
    }
    return mesh;
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";

  bool is_text() const { return header_.format == "ascii"; }

  /// Names the element that is read.
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, element_->name, " ", number_, " of ", element_->count, ": ", what...,
                    "; export the mesh again");
  }

  void check_header() {
    std::array<int, Property::other + 1> count_of{};
    for (const Element& element : header_.elements) {
      element_ = &element;
      if (element.count != 0 && element.properties.empty()) {
        refuse("no properties in the header");
      }
      if (element.name == "tristrips" && element.count != 0) {
        throw UserError(file_, "has triangle strips ('tristrips'); export the mesh as polygons");
      }
      for (const Property& property : element.properties) {
        ++count_of[property.role];
      }
    }
    const Element* const vertices = find(header_.elements, "vertex");
    if (vertices == nullptr || find(header_.elements, "face") == nullptr) {
      throw UserError(file_, "has no polygons ('vertex' and 'face'); export the mesh again");
    }
    vertex_count_ = vertices->count;
    for (const auto role : {Property::x, Property::y, Property::z}) {
      if (count_of[role] == 0) {
        throw UserError(file_, "has vertices without a number ",
                        quoted(std::string_view("xyz").substr(role, 1)), "; export the mesh again");
      }
    }
    if (count_of[Property::corners] != 1) {
      throw UserError(file_,
                      "has faces without one list of integers 'vertex_indices'; export the "
                      "mesh again");
    }
  }

  /// Keeps corners to the end of the file: faces may come before vertices.
  void read_element() {
    Position point{};
    for (const Property& property : element_->properties) {
      const double length = property.length ? number(*property.length) : 1;
      if (length < (property.role == Property::corners ? 3 : 0)) {
        refuse("a ", property.role == Property::corners ? "polygon" : "list", " of ",
               fixed(length, 0), property.role == Property::corners ? " corners" : "");
      }
      if (property.role == Property::corners) {
        polygons_.emplace_back();
      }
      for (double at = 0; at < length; ++at) {
        if (property.role == Property::corners) {
          polygons_.back().push_back(corner(number(property.value)));
        } else if (property.role == Property::other) {
          next(property.value);  // does not affect the shape: may be any word
        } else {
          point[property.role] = number(property.value);
        }
      }
    }
    if (element_->name == "vertex") {
      if (!std::all_of(point.begin(), point.end(), is_coordinate)) {
        refuse("no finite number of at most 3.4e38, which a coordinate must be");
      }
      builder_.add_point(point);
    }
  }

  /// The bytes of the next number, not empty.
  std::string_view next(const Type& type) {
    if (is_text()) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    }
    const std::size_t size = is_text() ? rest_.find_first_of(kBlanks) : type.size;
    if (rest_.size() < (is_text() ? 1 : size)) {
      refuse("the file ends here");
    }
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(found.size());
    return found;
  }

  double number(const Type& type) {
    const std::string_view found = next(type);
    if (is_text()) {
      const std::optional<double> value =
          type.is_floating ? parse_number(found) : std::optional<double>(parse_integer(found));
      if (!value) {
        refuse(quoted(found), " is no ", type.is_floating ? "finite " : "", type.name);
      }
      return *value;
    }
    std::string bytes(found);
    if (header_.format == "binary_big_endian") {
      std::reverse(bytes.begin(), bytes.end());
    }
    return type.value(bytes.data());
  }

  std::uint32_t corner(double number) const {
    if (number < 0 || number >= static_cast<double>(vertex_count_)) {
      refuse("a corner at vertex ", fixed(number, 0), " of ", vertex_count_);
    }
    return static_cast<std::uint32_t>(number);
  }

  const std::string& file_;
  Header header_;
  std::string_view rest_;             ///< not yet read
  const Element* element_ = nullptr;  ///< being read
  long long number_ = 0;              ///< of those with its name
  long long vertex_count_ = 0;
  std::vector<std::vector<std::uint32_t>> polygons_;
  MeshBuilder builder_;
};

}  // namespace

FileMesh read_ply(std::string_view bytes, const std::string& file) {
  refuse_other_contents(bytes, file);
  return PlyReader(bytes, file).read();
}

}  // namespace flashbvh::tool
