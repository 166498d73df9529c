// Robots' XML files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/xml.hpp"

namespace flashbvh::tool {

/// The contents of a file, whose outermost element is <robot>. UserError if it is malformed, a
/// xacro that is not expanded, or has another root.
XmlNode robot_xml(const std::string& path);

/// The first element of this name directly inside, or null.
const XmlNode* first_in(const XmlNode& element, std::string_view name);
/// The elements of this name directly inside, in order.
std::vector<const XmlNode*> elements_in(const XmlNode& element, std::string_view name);
/// The attribute's value; empty if there is none, or if the element is null.
std::string attribute(const XmlNode* element, std::string_view name);

/// A place for UserError: "arm.urdf, joint 'elbow'".
std::string at_element(const std::string& path, const char* kind, const std::string& name);

}  // namespace flashbvh::tool
