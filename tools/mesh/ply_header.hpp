// The header of a PLY file: its elements and their encoding.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// The type of a number.
struct PlyType {
  std::string_view name;
  std::string_view other_name;
  unsigned size;  ///< in bytes
  enum { is_signed, is_unsigned, is_floating } kind;
};

struct PlyProperty {
  std::string_view name;
  PlyType value;
  std::optional<PlyType> length;  ///< of the list's length; none if the property is one number
};

struct PlyElement {
  std::string_view name;
  long long count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Encoding { ascii, little_endian, big_endian };

  std::optional<Encoding> encoding;  ///< always present after reading
  std::vector<PlyElement> elements;  ///< with unique names; so are the properties of each
  std::string_view body;             ///< all that follows the header

  /// Null if there is no such element.
  const PlyElement* element(std::string_view name) const;
};

/// `text`: the whole file; the result points into it. UserError if it has no valid header.
PlyHeader read_ply_header(std::string_view text, const std::string& file);

}  // namespace flashbvh::tool
