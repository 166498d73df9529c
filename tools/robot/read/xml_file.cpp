#include "robot/read/xml_file.hpp"

#include <algorithm>

#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

/// UserError if the text is a xacro that is not expanded. `depth`: 0 for the root.
void refuse_xacro(const XmlNode& element, const std::string& path, int depth) {
  const std::string_view name = element.name;
  const bool is_old = depth == 1 && (name == "include" || name == "macro" || name == "property");
  std::string found = name.substr(0, 6) == "xacro:" || is_old ? concat("<", name, ">") : "";
  for (const auto& given : element.attributes) {
    const std::string& value = given.second;
    if (value.find("${") != std::string::npos || value.find("$(") != std::string::npos) {
      found = one_line(value);
    }
  }
  if (!found.empty()) {
    const char* const out = path.find(".srdf") == std::string::npos ? "OUT.urdf" : "OUT.srdf";
    throw UserError(at_line(path, element.line), "is a xacro (it has ", found,
                    "), not yet expanded; write `xacro ", path, " > ", out, "` and name ", out);
  }
  for (const XmlNode& inside : element.inside) {
    refuse_xacro(inside, path, depth + 1);
  }
}

}  // namespace

XmlNode robot_xml(const std::string& path) {
  XmlNode root = read_xml(read_file(path), path, "correct it there, or name a URDF or an SRDF");
  if (root.name == "mujoco" || root.name == "sdf") {
    throw UserError(path, "is ", root.name == "sdf" ? "SDF" : "MJCF", "; convert it to a URDF");
  }
  if (root.name != "robot") {
    throw UserError(path, "begins with <", root.name, ">, not with <robot>; name another file");
  }
  refuse_xacro(root, path, 0);
  return root;
}

const XmlNode* first_in(const XmlNode& element, std::string_view name) {
  const auto found = std::find_if(element.inside.begin(), element.inside.end(),
                                  [&](const XmlNode& e) { return e.name == name; });
  return found == element.inside.end() ? nullptr : &*found;
}

std::vector<const XmlNode*> elements_in(const XmlNode& element, std::string_view name) {
  std::vector<const XmlNode*> elements;
  for (const XmlNode& e : element.inside) {
    if (e.name == name) {
      elements.push_back(&e);
    }
  }
  return elements;
}

std::string attribute(const XmlNode* element, std::string_view name) {
  return element == nullptr ? "" : element->attribute(name);
}

std::string at_element(const std::string& path, const char* kind, const std::string& name) {
  return concat(path, ", ", kind, " ", tool::quoted(name));
}

}  // namespace flashbvh::tool
