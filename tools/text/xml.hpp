// XML texts as trees of elements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flashbvh::tool {

/// An element.
struct XmlNode {
  std::string name;      ///< with its prefix
  std::size_t line = 0;  ///< of the text, from 1
  /// Names, each once, and values, without entities and blanks around them.
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::vector<XmlNode> inside = {};
  std::string text = {};  ///< directly inside, without entities and blanks around it

  /// The attribute's value, or null.
  const std::string* find(std::string_view wanted) const;
  /// The attribute's value; empty if there is none.
  std::string attribute(std::string_view wanted) const;
};

/// The outermost element. UserError, at a line of `path`, if the text is malformed, nests elements
/// over 1000 deep, or has a document type that may define entities; `fix` ends the message.
XmlNode read_xml(std::string_view text, const std::string& path, const char* fix);

/// The text as an attribute's value within "".
std::string xml_value(std::string_view text);

}  // namespace flashbvh::tool
