// What a URDF may have: urdfdom skips the rest of a pose, a size or a limit in silence.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names);
/// True if the name has another program's namespace, such as drake:.
bool is_foreign(std::string_view name);

/// UserError for unknown attributes and elements, text, and a second element of a name, in an
/// element and all inside. `place`: of the link or joint.
void check_element(const XmlNode& element, const std::string& place);

/// UserError for shapes of a link that are in no <collision> or <visual>, and for an <origin> of a
/// link, which moves nothing.
void check_link(const XmlNode& link, const std::string& place);

}  // namespace flashbvh::tool
