// PLY: a header of elements and their properties, then the elements, as text or binary. Read to the
// end, to learn whether the file has all that its header announces.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "mesh/formats.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

enum class Encoding { ascii, little_endian, big_endian };

/// Of a number.
struct Type {
  std::string_view name;
  std::string_view other_name;
  unsigned size;  ///< in bytes
  enum { is_signed, is_unsigned, is_floating } kind;
};

struct Property {
  std::string_view name;
  Type value;
  std::optional<Type> length;  ///< of the list's length; absent if the property is one number
};

struct Element {
  std::string_view name;
  long long count;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
};

constexpr std::array<Type, 8> kTypes = {{{"char", "int8", 1, Type::is_signed},
                                         {"uchar", "uint8", 1, Type::is_unsigned},
                                         {"short", "int16", 2, Type::is_signed},
                                         {"ushort", "uint16", 2, Type::is_unsigned},
                                         {"int", "int32", 4, Type::is_signed},
                                         {"uint", "uint32", 4, Type::is_unsigned},
                                         {"float", "float32", 4, Type::is_floating},
                                         {"double", "float64", 8, Type::is_floating}}};

/// `text` is the whole file, which the header's names point into.
class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  Header read() {
    if (!lines_.next() || words_of(lines_.line()) != Words{"ply"}) {
      throw UserError(file_, "is no PLY file: it does not begin with 'ply'");
    }
    while (lines_.next()) {
      const Words words = words_of(lines_.line());
      if (!words.empty() && words[0] == "end_header") {
        return header_;
      }
      line(words);
    }
    throw UserError(at_line(file_, lines_.number()),
                    "the file ends in its header; export the mesh again");
  }

  std::string_view body() const { return lines_.rest(); }

 private:
  using Words = std::vector<std::string_view>;

  [[noreturn]] void refuse(const char* what) const {
    throw UserError(at_line(file_, lines_.number()), what, "; export the mesh again");
  }

  void line(const Words& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") {
      return;
    }
    if (words[0] == "format" && words.size() == 3) {
      header_.encoding = encoding(words[1]);
    } else if (words[0] == "element" && words.size() == 3) {
      const auto count = parse_integer(words[2]);
      if (!count || *count < 0) {
        refuse("an element without a count");
      }
      header_.elements.push_back({words[1], *count, {}});
    } else if (words[0] == "property" && !header_.elements.empty()) {
      header_.elements.back().properties.push_back(property(words));
    } else {
      refuse("no line of a PLY header");
    }
  }

  Encoding encoding(std::string_view name) const {
    if (name == "ascii") {
      return Encoding::ascii;
    }
    if (name == "binary_little_endian") {
      return Encoding::little_endian;
    }
    if (name == "binary_big_endian") {
      return Encoding::big_endian;
    }
    refuse("no format of PLY");
  }

  Property property(const Words& words) const {
    if (words.size() == 3) {
      return {words[2], type(words[1]), std::nullopt};
    }
    if (words.size() == 5 && words[1] == "list") {
      return {words[4], type(words[3]), type(words[2])};
    }
    refuse("no property of PLY");
  }

  Type type(std::string_view name) const {
    for (const Type& type : kTypes) {
      if (type.name == name || type.other_name == name) {
        return type;
      }
    }
    refuse("no type of PLY");
  }

  Lines lines_;
  const std::string& file_;
  Header header_;
};

/// The numbers after the header, one after the other.
class Body {
 public:
  Body(std::string_view bytes, Encoding encoding) : bytes_(bytes), encoding_(encoding) {}

  /// Nothing at the end of the file, or where no number is.
  std::optional<double> number(const Type& type) {
    return encoding_ == Encoding::ascii ? text_number() : binary_number(type);
  }
  bool at_end() const { return bytes_.find_first_not_of(" \t\r\n") == std::string_view::npos; }

 private:
  std::optional<double> text_number() {
    const std::size_t begin = bytes_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) {
      return std::nullopt;
    }
    bytes_.remove_prefix(begin);
    const std::string_view word = bytes_.substr(0, bytes_.find_first_of(" \t\r\n"));
    bytes_.remove_prefix(word.size());
    return parse_number(word);
  }

  std::optional<double> binary_number(const Type& type) {
    if (bytes_.size() < type.size) {
      return std::nullopt;
    }
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < type.size; ++i) {
      const unsigned at = encoding_ == Encoding::little_endian ? type.size - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at]);
    }
    bytes_.remove_prefix(type.size);
    if (type.kind == Type::is_floating) {
      return 0.0;  // indices and lengths are integers; assimp reads the rest
    }
    const double range = std::ldexp(1.0, static_cast<int>(8 * type.size));
    const auto value = static_cast<double>(bits);
    return type.kind == Type::is_signed && value >= range / 2 ? value - range : value;
  }

  std::string_view bytes_;
  Encoding encoding_;
};

/// Goes through all elements.
class Checker {
 public:
  Checker(const Header& header, Body body, const std::string& file)
      : header_(header), body_(body), file_(file), vertex_count_(count_of("vertex")) {}

  void check() {
    for (const Element& element : header_.elements) {
      if (element.count != 0 && element.properties.empty()) {
        refuse(element, 0, "no properties in the header");
      }
      for (long long i = 0; i < element.count; ++i) {
        for (const Property& property : element.properties) {
          check(element, i, property);
        }
      }
    }
    if (!body_.at_end()) {
      throw UserError(file_, "has more than its header announces; export the mesh again");
    }
  }

  long long count_of(std::string_view name) const {
    for (const Element& element : header_.elements) {
      if (element.name == name) {
        return element.count;
      }
    }
    return 0;
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Element& element, long long i, const Parts&... what) const {
    throw UserError(file_, element.name, " ", i, " of ", element.count, ": ", what...,
                    "; export the mesh again");
  }

  double number(const Element& element, long long i, const Type& type) {
    const auto value = body_.number(type);
    if (!value) {
      refuse(element, i,
             body_.at_end() ? "the file ends here" : "no finite number where one must be");
    }
    return *value;
  }

  void check(const Element& element, long long i, const Property& property) {
    if (!property.length) {
      number(element, i, property.value);
      return;
    }
    const double length = number(element, i, *property.length);
    const bool corners = element.name == "face" &&
                         (property.name == "vertex_indices" || property.name == "vertex_index");
    if (corners && length < 3) {
      refuse(element, i, "a polygon of ", shortest(length), " corners");
    }
    for (long long at = 0; static_cast<double>(at) < length; ++at) {
      const double value = number(element, i, property.value);
      if (corners && (value < 0 || value >= static_cast<double>(vertex_count_))) {
        refuse(element, i, "a corner at vertex ", shortest(value), " of ", vertex_count_);
      }
    }
  }

  const Header& header_;
  Body body_;
  const std::string& file_;
  long long vertex_count_;
};

}  // namespace

MeshText plain_ply(std::string bytes, const std::string& file) {
  HeaderReader reader(bytes, file);
  const Header header = reader.read();
  Checker checker(header, Body(reader.body(), header.encoding), file);
  checker.check();
  MeshText plain;
  plain.face_count = static_cast<std::size_t>(checker.count_of("face"));
  if (plain.face_count == 0) {
    throw UserError(file, "has no polygons; export the mesh again");
  }
  if (header.encoding == Encoding::ascii) {
    plain.warning = warn_of_cut_line(bytes);
  }
  plain.bytes = std::move(bytes);
  return plain;
}

}  // namespace flashbvh::tool
