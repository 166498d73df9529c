// PLY: behind the header the elements, as text or binary. Read to the end, to learn whether the
// file has all that its header announces.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh/formats.hpp"
#include "mesh/ply_header.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using ply::Element;
using ply::Encoding;
using ply::Header;
using ply::Property;
using ply::Type;

/// The numbers behind the header, one after the other.
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
  [[noreturn]] void refuse(const Element& element, long long i, const std::string& what) const {
    throw UserError(file_, std::string(element.name) + " " + std::to_string(i) + " of " +
                               std::to_string(element.count) + ": " + what +
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
      refuse(element, i, "a polygon of " + shortest(length) + " corners");
    }
    for (long long at = 0; static_cast<double>(at) < length; ++at) {
      const double value = number(element, i, property.value);
      if (corners && (value < 0 || value >= static_cast<double>(vertex_count_))) {
        refuse(element, i,
               "a corner at vertex " + shortest(value) + " of " + std::to_string(vertex_count_));
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
  std::string_view body;
  const Header header = ply::read_header(bytes, file, body);
  Checker checker(header, Body(body, header.encoding), file);
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
