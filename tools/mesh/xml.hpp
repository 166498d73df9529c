// XML by TinyXML, which urdfdom uses, too.
#pragma once

#include <tinyxml.h>

#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// Parses a text. UserError, at a line of `path`, if it is malformed; `fix` ends the message.
/// TinyXML recurses once per level of elements.
TiXmlElement& xml_root(std::string_view text, const std::string& path, const char* fix,
                       TiXmlDocument& document);

/// The elements directly inside, of this name or all, in order.
std::vector<TiXmlElement*> elements_in(TiXmlElement& element, const char* name = nullptr);

/// The attribute's value; empty if there is none, or if the element is null.
std::string attribute(const TiXmlElement* element, const char* name);

}  // namespace flashbvh::tool
