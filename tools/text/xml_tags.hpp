// The elements of an XML text and their attributes, in order, without a tree.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/xml_markup.hpp"

namespace flashbvh::tool {

/// A name without its prefix: "beamlattice" of "b:beamlattice".
std::string_view local_name(std::string_view name);

/// An element's start.
struct XmlTag {
  std::string_view name;  ///< with its prefix
  std::string_view attributes;
  std::string_view text;  ///< up to the next markup

  /// The attribute's value, entities as they are; ":NAME" is NAME with any prefix.
  std::optional<std::string_view> attribute(std::string_view name) const;
};

/// Reads a text's elements. UserError, at `place`, unless each that begins ends.
class XmlTags {
 public:
  XmlTags(std::string_view text, std::string place) : text_(text), place_(std::move(place)) {}

  /// The next element's start, or none.
  std::optional<XmlTag> next();
  /// The local name of the element around the last one; empty for the outermost.
  std::string_view parent() const;

 private:
  [[noreturn]] void refuse() const;

  std::string_view text_;
  std::string place_;
  std::size_t at_ = 0;
  std::vector<std::string_view> open_;  ///< names of the elements around, and of the last one
  bool is_in_last_ = false;
};

}  // namespace flashbvh::tool
