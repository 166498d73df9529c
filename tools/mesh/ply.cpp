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
  unsigned size;  ///< in bytes
  enum { is_signed, is_unsigned, is_floating } kind;
};

constexpr std::array<Type, 8> kTypes = {{{"char", "int8", 1, Type::is_signed},
                                         {"uchar", "uint8", 1, Type::is_unsigned},
                                         {"short", "int16", 2, Type::is_signed},
                                         {"ushort", "uint16", 2, Type::is_unsigned},
                                         {"int", "int32", 4, Type::is_signed},
                                         {"uint", "uint32", 4, Type::is_unsigned},
                                         {"float", "float32", 4, Type::is_floating},
                                         {"double", "float64", 8, Type::is_floating}}};

enum class Encoding { ascii, little_endian, big_endian };
constexpr std::array<std::string_view, 3> kEncodings = {"ascii", "binary_little_endian",
                                                        "binary_big_endian"};

struct Property {
  std::string_view name;
  Type value;
  std::optional<Type> length;  ///< of a list's length
  enum { other, x, y, z, corners } role = other;
};

struct Element {
  std::string_view name;
  long long count;
  std::vector<Property> properties;
};

/// Element and property names are unique where they belong.
struct Header {
  std::optional<Encoding> encoding;  ///< always present after reading
  std::vector<Element> elements;
  std::string_view body;  ///< all that follows the header
};

template <class Named>
auto find(std::vector<Named>& all, std::string_view name) {
  return std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
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
        need(header_.encoding.has_value(), "the header ends without a 'format'");
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
    if (words[0] == "format" && words.size() == 3 && !header_.encoding) {
      const auto* const found = std::find(kEncodings.begin(), kEncodings.end(), words[1]);
      need(found != kEncodings.end(), "no format of PLY");
      header_.encoding = static_cast<Encoding>(found - kEncodings.begin());
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = parse_integer(words[2]);
      need(count && *count >= 0, "an element without a count");
      need(find(header_.elements, words[1]) == header_.elements.end(), "a second element ",
           quoted(words[1]));
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
    std::vector<Property>& known = header_.elements.back().properties;
    need(find(known, words.back()) == known.end(), "a second property ", quoted(words.back()));
    Property made = {words.back(), type(words[words.size() - 2]), {}};
    if (is_list) {
      made.length = type(words[2]);
      need(made.length->kind != Type::is_floating, "a list whose length is no integer");
    }
    known.push_back(made);
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

/// Reads the numbers after the header in order.
class Body {
 public:
  explicit Body(const Header& header) : bytes_(header.body), encoding_(*header.encoding) {}

  /// None if there is no such number; integers to 32 bits are exact.
  std::optional<double> number(const Type& type) {
    if (encoding_ == Encoding::ascii) {
      bytes_.remove_prefix(std::min(bytes_.find_first_not_of(kBlanks), bytes_.size()));
      word_ = bytes_.substr(0, bytes_.find_first_of(kBlanks));
      bytes_.remove_prefix(word_.size());
      return type.kind == Type::is_floating ? parse_number(word_) : integer(parse_integer(word_));
    }
    word_ = bytes_.substr(0, type.size);
    if (word_.size() < type.size) {
      word_ = {};
      return std::nullopt;
    }
    bytes_.remove_prefix(type.size);
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < type.size; ++i) {
      const unsigned at = encoding_ == Encoding::little_endian ? type.size - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(word_[at]);
    }
    if (type.kind == Type::is_floating) {
      return type.size == 8
                 ? number_of<double>(bits)
                 : static_cast<double>(number_of<float>(static_cast<std::uint32_t>(bits)));
    }
    const auto value = static_cast<long long>(bits);
    const long long range = 1LL << 8 * type.size;
    return integer(type.kind == Type::is_signed && value >= range / 2 ? value - range : value);
  }

  /// That number() read last; empty at the end of the file.
  std::string_view word() const { return word_; }
  bool at_end() const {
    return without_padding(bytes_).find_first_not_of(kBlanks) == std::string_view::npos;
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";

  static std::optional<double> integer(std::optional<long long> value) {
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
  }

  template <class Number, class Bits>
  static Number number_of(Bits bits) {
    static_assert(sizeof(Number) == sizeof bits);
    Number number{};
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  std::string_view bytes_;
  std::string_view word_;
  Encoding encoding_;
};

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& file)
      : file_(file), header_(HeaderReader(text, file).read()), body_(header_), builder_(file) {}

  FileMesh read() {
    check_header();
    for (const Element& element : header_.elements) {
      element_ = &element;
      for (number_ = 0; number_ < element.count; ++number_) {
        read_element();
      }
    }
    if (!body_.at_end()) {
      throw UserError(file_, "has more than its header announces; export the mesh again");
    }
    for (const std::vector<std::uint32_t>& polygon : polygons_) {
      builder_.add_polygon(polygon);
    }
    return builder_.finish();
  }

  bool is_text() const { return header_.encoding == Encoding::ascii; }

 private:
  /// Names the element that is read.
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, element_->name, " ", number_, " of ", element_->count, ": ", what...,
                    "; export the mesh again");
  }

  /// Finds the coordinates and the corners.
  void check_header() {
    for (const Element& element : header_.elements) {
      element_ = &element;
      if (element.count != 0 && element.properties.empty()) {
        refuse("no properties in the header");
      }
      if (element.name == "tristrips" && element.count != 0) {
        throw UserError(file_, "has triangle strips ('tristrips'); export the mesh as polygons");
      }
    }
    const auto vertices = find(header_.elements, "vertex");
    const auto faces = find(header_.elements, "face");
    if (vertices == header_.elements.end() || faces == header_.elements.end()) {
      throw UserError(file_, "has no polygons ('vertex' and 'face'); export the mesh again");
    }
    vertex_count_ = vertices->count;
    for (const auto role : {Property::x, Property::y, Property::z}) {
      const std::string_view name = std::string_view("xyz").substr(role - Property::x, 1);
      const auto found = find(vertices->properties, name);
      if (found == vertices->properties.end() || found->length) {
        throw UserError(file_, "has vertices without a number ", quoted(name),
                        "; export the mesh again");
      }
      found->role = role;
    }
    int lists = 0;
    for (Property& property : faces->properties) {
      if (property.length && property.value.kind != Type::is_floating &&
          (property.name == "vertex_indices" || property.name == "vertex_index")) {
        property.role = Property::corners;
        ++lists;
      }
    }
    if (lists != 1) {
      throw UserError(file_,
                      "has faces without one list of integers 'vertex_indices'; export the "
                      "mesh again");
    }
  }

  /// Keeps corners to the end of the file: faces may come before vertices.
  void read_element() {
    Position point{};
    for (const Property& property : element_->properties) {
      const double length = property.length ? length_of(property) : 1;
      if (property.role == Property::corners) {
        polygons_.emplace_back();
      }
      for (double at = 0; at < length; ++at) {
        if (property.role == Property::other) {
          skip(property.value);
        } else if (property.role == Property::corners) {
          polygons_.back().push_back(corner(number(property.value)));
        } else {
          point[property.role - Property::x] = coordinate(number(property.value));
        }
      }
    }
    if (element_->name == "vertex") {
      builder_.add_point(point);
    }
  }

  double length_of(const Property& property) {
    const double length = number(*property.length);
    if (property.role == Property::corners && length < 3) {
      refuse("a polygon of ", fixed(length, 0), " corners");
    }
    if (length < 0) {
      refuse("a list of ", fixed(length, 0));
    }
    return length;
  }

  double number(const Type& type) {
    const std::optional<double> value = body_.number(type);
    if (!value && body_.word().empty()) {
      refuse("the file ends here");
    }
    if (!value) {
      refuse(quoted(body_.word()), " is no ", type.kind == Type::is_floating ? "finite " : "",
             type.name);
    }
    return *value;
  }

  /// A number that does not affect the shape may be any word.
  void skip(const Type& type) {
    (void)body_.number(type);
    if (body_.word().empty()) {
      refuse("the file ends here");
    }
  }

  double coordinate(double number) const {
    if (!is_coordinate(number)) {
      refuse("no finite number of at most 3.4e38, which a coordinate must be");
    }
    return number;
  }

  std::uint32_t corner(double number) const {
    if (number < 0 || number >= static_cast<double>(vertex_count_)) {
      refuse("a corner at vertex ", fixed(number, 0), " of ", vertex_count_);
    }
    return static_cast<std::uint32_t>(number);
  }

  const std::string& file_;
  Header header_;
  Body body_;
  const Element* element_ = nullptr;  ///< being read
  long long number_ = 0;              ///< of those with its name
  long long vertex_count_ = 0;
  std::vector<std::vector<std::uint32_t>> polygons_;
  MeshBuilder builder_;
};

}  // namespace

FileMesh read_ply(std::string_view bytes, const std::string& file) {
  refuse_other_contents(bytes, file);
  PlyReader reader(bytes, file);
  FileMesh mesh = reader.read();
  if (reader.is_text()) {
    warn_of_cut_line(without_padding(bytes), mesh);
  }
  return mesh;
}

}  // namespace flashbvh::tool
