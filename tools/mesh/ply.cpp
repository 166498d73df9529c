// PLY: a header of elements and their properties, then the elements, as text or binary. Vertices
// and faces make the mesh. Other elements are read only to check that the file has all that its
// header announces.
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
#include "mesh/ply_header.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Encoding = PlyHeader::Encoding;

/// Reads the numbers after the header in order. None at the end of the file, or if no such number
/// follows.
class Body {
 public:
  explicit Body(const PlyHeader& header) : bytes_(header.body), encoding_(*header.encoding) {}

  std::optional<long long> integer(const PlyType& type) {
    if (encoding_ == Encoding::ascii) {
      return parse_integer(word());
    }
    const auto bits = binary(type);
    if (!bits) {
      return std::nullopt;
    }
    const long long range = 1LL << 8 * type.size;
    const auto value = static_cast<long long>(*bits);
    return type.kind == PlyType::is_signed && value >= range / 2 ? value - range : value;
  }

  std::optional<double> real(const PlyType& type) {
    if (type.kind != PlyType::is_floating) {
      const auto value = integer(type);
      return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
    }
    if (encoding_ == Encoding::ascii) {
      return parse_number(word());
    }
    const auto bits = binary(type);
    if (!bits) {
      return std::nullopt;
    }
    return type.size == 4 ? static_cast<double>(number_of<float>(static_cast<std::uint32_t>(*bits)))
                          : number_of<double>(*bits);
  }

  /// Skips a number that does not affect the shape; false at the end of the file.
  bool skip(const PlyType& type) {
    return encoding_ == Encoding::ascii ? !word().empty() : binary(type).has_value();
  }

  /// In a text; empty at the end of the file and in a binary.
  std::string_view last_word() const { return last_word_; }
  bool at_end() const {
    return without_padding(bytes_).find_first_not_of(kBlanks) == std::string_view::npos;
  }

 private:
  static constexpr std::string_view kBlanks = " \t\r\n";

  /// The next word; empty at the end of the file.
  std::string_view word() {
    bytes_.remove_prefix(std::min(bytes_.find_first_not_of(kBlanks), bytes_.size()));
    last_word_ = bytes_.substr(0, bytes_.find_first_of(kBlanks));
    bytes_.remove_prefix(last_word_.size());
    return last_word_;
  }

  std::optional<std::uint64_t> binary(const PlyType& type) {
    if (bytes_.size() < type.size) {
      return std::nullopt;
    }
    std::uint64_t bits = 0;
    for (unsigned i = 0; i < type.size; ++i) {
      const unsigned at = encoding_ == Encoding::little_endian ? type.size - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at]);
    }
    bytes_.remove_prefix(type.size);
    return bits;
  }

  template <class Number, class Bits>
  static Number number_of(Bits bits) {
    static_assert(sizeof(Number) == sizeof bits);
    Number number{};
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  std::string_view bytes_;
  std::string_view last_word_;
  Encoding encoding_;
};

bool holds_corners(const PlyProperty& property) {
  return property.length && property.value.kind != PlyType::is_floating &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& file)
      : file_(file), header_(read_ply_header(text, file)), body_(header_), builder_(file) {}

  FileMesh read() {
    check_header();
    for (const PlyElement& element : header_.elements) {
      for (long long i = 0; i < element.count; ++i) {
        read(element, i);
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
  template <class... Parts>
  [[noreturn]] void refuse(const PlyElement& element, long long i, const Parts&... what) const {
    throw UserError(file_, element.name, " ", i, " of ", element.count, ": ", what...,
                    "; export the mesh again");
  }

  template <class Number>
  Number need(std::optional<Number> value, const PlyType& type, const PlyElement& element,
              long long i) const {
    if (!value && body_.last_word().empty()) {
      refuse(element, i, "the file ends here");
    }
    if (!value) {
      refuse(element, i, quoted(body_.last_word()), " is no ",
             type.kind == PlyType::is_floating ? "finite " : "", type.name);
    }
    return *value;
  }

  void check_header() {
    for (const PlyElement& element : header_.elements) {
      if (element.count != 0 && element.properties.empty()) {
        refuse(element, 0, "no properties in the header");
      }
    }
    if (const PlyElement* strips = header_.element("tristrips"); strips && strips->count != 0) {
      throw UserError(file_, "has triangle strips ('tristrips'); export the mesh as polygons");
    }
    vertices_ = header_.element("vertex");
    faces_ = header_.element("face");
    if (vertices_ == nullptr || faces_ == nullptr) {
      throw UserError(file_, "has no polygons ('vertex' and 'face'); export the mesh again");
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view name = std::string_view("xyz").substr(axis, 1);
      const auto& properties = vertices_->properties;
      const auto found = std::find_if(properties.begin(), properties.end(), [&](const auto& known) {
        return known.name == name && !known.length;
      });
      if (found == properties.end()) {
        throw UserError(file_, "has vertices without a number ", quoted(name),
                        "; export the mesh again");
      }
      axes_[axis] = static_cast<std::size_t>(found - properties.begin());
    }
    if (std::count_if(faces_->properties.begin(), faces_->properties.end(), holds_corners) != 1) {
      throw UserError(file_,
                      "has faces without one list of integers 'vertex_indices'; export the "
                      "mesh again");
    }
  }

  void read(const PlyElement& element, long long i) {
    Position point{};
    for (std::size_t at = 0; at < element.properties.size(); ++at) {
      const PlyProperty& property = element.properties[at];
      const auto axis = std::find(axes_.begin(), axes_.end(), at);
      if (&element == vertices_ && axis != axes_.end()) {
        const double value = need(body_.real(property.value), property.value, element, i);
        if (!is_coordinate(value)) {
          refuse(element, i, "no finite number of at most 3.4e38, which a coordinate must be");
        }
        point[static_cast<std::size_t>(axis - axes_.begin())] = value;
      } else if (&element == faces_ && holds_corners(property)) {
        read_corners(property, i);
      } else {
        skip(element, i, property);
      }
    }
    if (&element == vertices_) {
      builder_.add_point(point);
    }
  }

  /// Keeps the corners to the end of the file: faces may come before vertices.
  void read_corners(const PlyProperty& property, long long i) {
    const long long length = need(body_.integer(*property.length), *property.length, *faces_, i);
    if (length < 3) {
      refuse(*faces_, i, "a polygon of ", length, " corners");
    }
    polygons_.emplace_back();
    for (long long at = 0; at < length; ++at) {
      const long long corner = need(body_.integer(property.value), property.value, *faces_, i);
      if (corner < 0 || corner >= vertices_->count) {
        refuse(*faces_, i, "a corner at vertex ", corner, " of ", vertices_->count);
      }
      polygons_.back().push_back(static_cast<std::uint32_t>(corner));
    }
  }

  void skip(const PlyElement& element, long long i, const PlyProperty& property) {
    const long long length =
        property.length ? need(body_.integer(*property.length), *property.length, element, i) : 1;
    if (length < 0) {
      refuse(element, i, "a list of ", length);
    }
    for (long long at = 0; at < length; ++at) {
      if (!body_.skip(property.value)) {
        refuse(element, i, "the file ends here");
      }
    }
  }

  const std::string& file_;
  PlyHeader header_;
  Body body_;
  const PlyElement* vertices_ = nullptr;
  const PlyElement* faces_ = nullptr;
  std::array<std::size_t, 3> axes_{};  ///< the vertices' properties x, y and z
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
