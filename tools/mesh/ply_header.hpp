// The header of a PLY file: its elements and their properties.
#ifndef FLASHBVH_TOOLS_MESH_PLY_HEADER_HPP
#define FLASHBVH_TOOLS_MESH_PLY_HEADER_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool::ply {

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

/// `text` is the whole file, which the header's names point into. `body`: where its elements begin.
/// UserError, naming `file`, if it is no PLY file or its header is cut off.
Header read_header(std::string_view text, const std::string& file, std::string_view& body);

}  // namespace flashbvh::tool::ply

#endif
