#include "text/xml.hpp"

#include <expat.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// Functions on trees recurse once per level.
constexpr std::size_t kMostLevels = 1000;
constexpr std::size_t kChunk = std::size_t{1} << 20;  ///< bytes; expat takes an int
constexpr const char* kXmlBlanks = " \t\r\n";

std::string without_blanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kXmlBlanks), text.size());
  return std::string(text.substr(begin, text.find_last_not_of(kXmlBlanks) + 1 - begin));
}

class TreeReader {
 public:
  explicit TreeReader(const std::string& path) : path_(path) {
    XML_SetUserData(parser(), this);
    XML_SetElementHandler(parser(), guarded<&TreeReader::start, const char*, const char**>,
                          guarded<&TreeReader::end, const char*>);
    XML_SetCharacterDataHandler(parser(), guarded<&TreeReader::add_text, const char*, int>);
    XML_SetStartDoctypeDeclHandler(
        parser(), guarded<&TreeReader::document_type, const char*, const char*, const char*, int>);
  }

  XmlNode read(std::string_view text, const char* fix) {
    for (bool is_last = false; !is_last; text.remove_prefix(std::min(kChunk, text.size()))) {
      const std::string_view chunk = text.substr(0, kChunk);
      is_last = chunk.size() == text.size();
      if (XML_Parse(parser(), chunk.data(), static_cast<int>(chunk.size()), is_last) !=
          XML_STATUS_OK) {
        refuse(fix);
      }
    }
    return std::move(open_[0].inside[0]);
  }

 private:
  /// Calls the member; keeps what it throws, which must not pass through expat.
  template <auto kMember, class... Values>
  static void guarded(void* self, Values... values) {
    auto& reader = *static_cast<TreeReader*>(self);
    try {
      if (!reader.thrown_) {  // expat ends an empty element even after a stop
        (reader.*kMember)(values...);
      }
    } catch (...) {
      reader.thrown_ = std::current_exception();
      XML_StopParser(reader.parser(), XML_FALSE);
    }
  }

  XML_Parser parser() const { return parser_.get(); }
  std::size_t line() const { return XML_GetCurrentLineNumber(parser()); }

  [[noreturn]] void refuse(const char* fix) const {
    if (thrown_) {
      std::rethrow_exception(thrown_);
    }
    const std::string where =
        open_.size() == 1 ? "" : concat(" in <", tool::quoted(open_.back().name), ">");
    throw UserError(at_line(path_, line()),
                    "is no XML: ", XML_ErrorString(XML_GetErrorCode(parser())), where, "; ", fix);
  }

  void document_type(const char*, const char* file, const char*, int has_declarations) {
    if (file != nullptr || has_declarations != 0) {
      throw UserError(at_line(path_, line()), "has a <!DOCTYPE> with ",
                      file != nullptr ? tool::quoted(file) : "declarations",
                      ", which is not read; write it without");
    }
  }

  void start(const char* name, const char** attributes) {
    if (open_.size() > kMostLevels) {
      throw UserError(path_, "nests elements over ", kMostLevels, " deep; write it again");
    }
    XmlNode& made = open_.emplace_back(XmlNode{name, line()});
    for (; *attributes != nullptr; attributes += 2) {
      made.attributes.emplace_back(attributes[0], without_blanks(attributes[1]));
    }
  }

  void end(const char*) {
    XmlNode made = std::move(open_.back());
    made.text = without_blanks(made.text);
    open_.pop_back();
    open_.back().inside.push_back(std::move(made));
  }

  void add_text(const char* bytes, int count) {
    std::string& known = open_.back().text;
    const std::string_view text(bytes, static_cast<std::size_t>(count));
    if (!known.empty() || text.find_first_not_of(kXmlBlanks) < text.size()) {
      known += text;
    }
  }

  const std::string& path_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_ = {XML_ParserCreate(nullptr),
                                                                          &XML_ParserFree};
  std::vector<XmlNode> open_ = {{}};  ///< from the document inwards
  std::exception_ptr thrown_;         ///< by a handler
};

}  // namespace

const std::string* XmlNode::find(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const auto& given) { return given.first == wanted; });
  return found == attributes.end() ? nullptr : &found->second;
}

std::string XmlNode::attribute(std::string_view wanted) const {
  const std::string* const value = find(wanted);
  return value == nullptr ? "" : *value;
}

XmlNode read_xml(std::string_view text, const std::string& path, const char* fix) {
  if (text.find('\0') != std::string_view::npos) {
    throw UserError(path, "is no text, so no XML; ", fix);
  }
  return TreeReader(path).read(text, fix);
}

std::string xml_value(std::string_view text) {
  std::string value;
  for (const char c : text) {
    value += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return value;
}

}  // namespace flashbvh::tool
