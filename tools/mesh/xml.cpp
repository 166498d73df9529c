#include "mesh/xml.hpp"

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// TinyXML reads as many bytes of a character as its first byte announces, even beyond the end.
constexpr std::size_t kLongestCharacter = 4;

}  // namespace

TiXmlElement& xml_root(std::string_view text, const std::string& path, const char* fix,
                       TiXmlDocument& document) {
  if (text.find('\0') != std::string_view::npos) {
    throw UserError(path, "is no text, so no XML; ", fix);
  }
  const std::string padded = std::string(text) + std::string(kLongestCharacter, '\0');
  document.Parse(padded.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document.Error() || document.RootElement() == nullptr) {
    const std::string what = one_line(document.Error() ? document.ErrorDesc() : "no element");
    const auto line = static_cast<std::size_t>(document.ErrorRow());  // 0 at the end of the file
    throw UserError(line == 0 ? path : at_line(path, line),
                    "is no XML: ", what.substr(0, what.find_last_not_of('.') + 1), "; ", fix);
  }
  return *document.RootElement();
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

}  // namespace flashbvh::tool
