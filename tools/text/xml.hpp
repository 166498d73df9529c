// XML texts as trees of elements.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flashbvh::tool {

/// An element. Views lead into the text that was read.
struct XmlNode {
  std::string_view name;  ///< with its prefix
  std::size_t line = 0;   ///< of the text, from 1
  /// Names, each once, and values, without entities and blanks around them.
  std::vector<std::pair<std::string_view, std::string>> attributes = {};
  std::vector<XmlNode> inside = {};
  std::string_view text = {};  ///< the first text directly inside, as it is

  /// The attribute's value, or null.
  const std::string* find(std::string_view wanted) const;
  /// The attribute's value; empty if there is none.
  std::string attribute(std::string_view wanted) const;
};

/// The outermost element. UserError, at a line of `path`, if the text is malformed or nests
/// elements over 1000 deep; `fix` ends the message.
XmlNode read_xml(std::string_view text, const std::string& path, const char* fix);

}  // namespace flashbvh::tool
