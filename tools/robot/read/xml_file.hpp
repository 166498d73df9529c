// Reads XML files with TinyXML, which urdfdom uses, too.
#pragma once

#include <tinyxml.h>

#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// The name of an XML text's outermost element, by its first bytes alone; empty if there is none.
std::string_view root_element(std::string_view text);

/// Reads a file whose outermost element is <`root`>. UserError if it is missing, malformed, nested
/// deeper than any robot, a xacro that is not expanded, or has another root.
void read_xml(const std::string& path, const char* root, TiXmlDocument& document);
/// Parses a text like read_xml(). `path`: for messages.
void parse_xml(std::string text, const std::string& path, const char* root,
               TiXmlDocument& document);

/// The elements directly inside, of this name or all, in order.
std::vector<TiXmlElement*> elements_in(TiXmlElement& element, const char* name = nullptr);

/// The attribute's value; empty if there is none, or if the element is null.
std::string attribute(const TiXmlElement* element, const char* name);

/// A place for UserError: "arm.urdf, joint 'elbow'".
std::string at_element(const std::string& path, const char* kind, const std::string& name);

}  // namespace flashbvh::tool
