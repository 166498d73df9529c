// The header of a PLY file: what elements it holds, and in what form.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// Of a number.
struct PlyType {
  std::string_view name;
  std::string_view other_name;
  unsigned size;  ///< in bytes
  enum { is_signed, is_unsigned, is_floating } kind;
};

struct PlyProperty {
  std::string_view name;
  PlyType value;
  std::optional<PlyType> length;  ///< of the list's length; absent if the property is one number
};

struct PlyElement {
  std::string_view name;
  long long count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Encoding { ascii, little_endian, big_endian };

  std::optional<Encoding> encoding;  ///< always there once read
  std::vector<PlyElement> elements;  ///< no two of a name, nor two properties of one
  std::string_view body;             ///< what comes after the header

  /// Null if there is none.
  const PlyElement* element(std::string_view name) const;
};

/// `text`: the whole file, which the result points into. UserError if it has no such header.
PlyHeader read_ply_header(std::string_view text, const std::string& file);

}  // namespace flashbvh::tool
