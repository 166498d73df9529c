#include "robot/read/xml_file.hpp"

#include <string_view>

#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/xml_markup.hpp"

namespace flashbvh::tool {
namespace {

/// TinyXML recurses once per level.
constexpr std::size_t kMostLevels = 1000;
/// TinyXML reads as many bytes of a character as its first byte announces, even beyond the end.
constexpr std::size_t kLongestCharacter = 4;

/// UserError if the text is a xacro that is not expanded. `is_top`: of an element in the root.
void refuse_xacro(const TiXmlElement& element, const std::string& path, bool is_top) {
  const std::string& name = element.ValueStr();
  const bool is_old = is_top && (name == "include" || name == "macro" || name == "property");
  std::string found = name.compare(0, 6, "xacro:") == 0 || is_old ? "<" + name + ">" : "";
  for (const TiXmlAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    const std::string& value = a->ValueStr();
    if (value.find("${") != std::string::npos || value.find("$(") != std::string::npos) {
      found = one_line(value);
    }
  }
  if (!found.empty()) {
    const char* const out = path.find(".srdf") == std::string::npos ? "OUT.urdf" : "OUT.srdf";
    throw UserError(at_line(path, static_cast<std::size_t>(element.Row())), "is a xacro (it has ",
                    found, "), not yet expanded; write `xacro ", path, " > ", out, "` and name ",
                    out);
  }
  for (const TiXmlElement* e = element.FirstChildElement(); e != nullptr;
       e = e->NextSiblingElement()) {
    refuse_xacro(*e, path, false);
  }
}

}  // namespace

std::string_view root_element(std::string_view text) {
  for (;;) {
    text.remove_prefix(behind(text, "<"));
    if (text.empty()) {
      return text;
    }
    if (text[0] == '?') {
      text.remove_prefix(behind(text, "?>"));
    } else if (text.substr(0, 3) == "!--") {
      text.remove_prefix(behind(text, "-->"));
    } else if (text[0] != '!') {
      return text.substr(0, text.find_first_of(" \t\r\n/>"));
    }
  }
}

void read_xml(const std::string& path, const char* root, TiXmlDocument& document) {
  parse_xml(read_file(path), path, root, document);
}

void parse_xml(std::string text, const std::string& path, const char* root,
               TiXmlDocument& document) {
  if (text.find('\0') != std::string::npos) {
    throw UserError(path, "is no text, so no XML; name the robot's file");
  }
  if (levels_of(text) > kMostLevels) {
    throw UserError(path, "nests elements over ", kMostLevels, " deep; write it again");
  }
  text.append(kLongestCharacter, '\0');
  document.Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error()) {
    const std::string what = one_line(document.ErrorDesc());
    const auto line = static_cast<std::size_t>(document.ErrorRow());  // 0 at the end of the file
    throw UserError(line == 0 ? path : at_line(path, line),
                    "is no XML: ", what.substr(0, what.find_last_not_of('.') + 1),
                    "; correct it there");
  }
  const TiXmlElement* const found = document.RootElement();
  const std::string_view name = found == nullptr ? "" : found->Value();
  if (name != root) {
    throw UserError(path, "begins with <", found == nullptr ? "nothing" : found->Value(),
                    ">, not with <", root, ">; name another file");
  }
  for (const TiXmlElement* e : elements_in(*document.RootElement())) {
    refuse_xacro(*e, path, true);
  }
}

std::vector<TiXmlElement*> elements_in(TiXmlElement& element, const char* name) {
  std::vector<TiXmlElement*> elements;
  for (TiXmlElement* e = element.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    if (name == nullptr || e->ValueStr() == name) {
      elements.push_back(e);
    }
  }
  return elements;
}

std::string attribute(const TiXmlElement* element, const char* name) {
  const char* const value = element == nullptr ? nullptr : element->Attribute(name);
  return value == nullptr ? "" : value;
}

std::string at_element(const std::string& path, const char* kind, const std::string& name) {
  return concat(path, ", ", kind, " ", tool::quoted(name));
}

}  // namespace flashbvh::tool
