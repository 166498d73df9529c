#include "text/xml.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// Functions on trees recurse once per level.
constexpr std::size_t kMostLevels = 1000;
constexpr const char* kXmlBlanks = " \t\r\n";

std::string utf8_of(std::uint32_t code) {
  if (code < 0x80) {
    return std::string(1, static_cast<char>(code));
  }
  const unsigned more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  std::string bytes(1, static_cast<char>(0xFF00u >> (more + 1) | code >> (6 * more)));
  for (unsigned i = more; i-- != 0;) {
    bytes += static_cast<char>(0x80 | (code >> (6 * i) & 0x3F));
  }
  return bytes;
}

/// What an entity stands for, such as "amp" or "#xE9"; empty for an unknown one.
std::string character_of(std::string_view entity) {
  constexpr std::pair<std::string_view, const char*> kNamed[] = {
      {"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}};
  for (const auto& [name, character] : kNamed) {
    if (entity == name) {
      return character;
    }
  }
  if (entity.substr(0, 1) != "#") {
    return {};
  }
  const bool is_hexadecimal = entity.substr(0, 2) == "#x";
  entity.remove_prefix(is_hexadecimal ? 2 : 1);
  std::uint32_t code = 0;
  const char* const end = entity.data() + entity.size();
  const auto read = std::from_chars(entity.data(), end, code, is_hexadecimal ? 16 : 10);
  const bool is_known = read.ec == std::errc() && read.ptr == end && code != 0 && code <= 0x10FFFF;
  return is_known ? utf8_of(code) : "";
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kXmlBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kXmlBlanks) + 1 - begin);
}

bool begins_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x80 || std::isalpha(byte) != 0 || c == '_';
}

bool is_of_name(char c) {
  return begins_name(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("-.:").find(c) != std::string_view::npos;
}

class TreeReader {
 public:
  TreeReader(std::string_view text, const std::string& path, const char* fix)
      : text_(text), path_(path), fix_(fix) {}

  XmlNode read() {
    XmlNode document;
    open_ = {&document};
    take("\xEF\xBB\xBF");
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('<', at_), text_.size());
      add_text(text_.substr(at_, end - at_));
      at_ = end;
      if (at_ < text_.size()) {
        markup();
      }
    }
    need(open_.size() == 1);
    need(!document.inside.empty(), "has no element");
    return std::move(document.inside[0]);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) {
    const std::string where =
        open_.size() == 1 ? "" : concat(" in <", quoted(open_.back()->name), ">");
    throw UserError(at_line(path_, line()), "is no XML: ", one_line(what), where, "; ", fix_);
  }

  void need(bool is_so, const char* otherwise = "is damaged or cut off") {
    if (!is_so) {
      refuse(otherwise);
    }
  }

  std::size_t line() {
    line_ += static_cast<std::size_t>(std::count(
        text_.begin() + counted_, text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    counted_ = static_cast<std::ptrdiff_t>(at_);
    return line_;
  }

  /// Moves behind `mark` if it is next.
  bool take(std::string_view mark) {
    const bool is_next = text_.compare(at_, mark.size(), mark) == 0;
    at_ += is_next ? mark.size() : 0;
    return is_next;
  }

  /// Moves behind the next `mark`; returns what is before it.
  std::string_view take_to(std::string_view mark) {
    const std::size_t end = text_.find(mark, at_);
    need(end != std::string_view::npos);
    const std::string_view before = text_.substr(at_, end - at_);
    at_ = end + mark.size();
    return before;
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kXmlBlanks, at_), text_.size()); }

  std::string_view take_name() {
    const std::size_t begin = at_;
    need(at_ < text_.size() && begins_name(text_[at_]));
    while (at_ < text_.size() && is_of_name(text_[at_])) {
      ++at_;
    }
    return text_.substr(begin, at_ - begin);
  }

  void add_text(std::string_view text) {
    if (text = without_blanks(text); !text.empty()) {
      need(open_.size() > 1, "has text outside of elements");
      std::string_view& known = open_.back()->text;
      known = known.empty() ? text : known;
    }
  }

  void markup() {
    if (take("<!--")) {
      take_to("-->");
    } else if (take("<![CDATA[")) {
      add_text(take_to("]]>"));
    } else if (take("<?")) {
      if (take_name() == "xml") {
        attributes();
        need(take("?>"));
      } else {
        take_to("?>");
      }
    } else if (take("<!")) {
      take_to(">");
    } else if (take("</")) {
      need(take_name() == open_.back()->name);  // the document has none
      skip_blanks();
      need(take(">"));
      open_.pop_back();
    } else {
      ++at_;
      start();
    }
  }

  void start() {
    XmlNode made = {take_name(), line()};
    if (open_.size() == 1 && !open_[0]->inside.empty()) {
      refuse(concat("has a second root <", made.name, ">"));
    }
    if (open_.size() > kMostLevels) {
      throw UserError(path_, "nests elements over ", kMostLevels, " deep; write it again");
    }
    made.attributes = attributes();
    const bool is_empty = take("/");
    need(take(">"));
    open_.back()->inside.push_back(std::move(made));
    if (!is_empty) {
      open_.push_back(&open_.back()->inside.back());
    }
  }

  std::vector<std::pair<std::string_view, std::string>> attributes() {
    XmlNode made;
    for (skip_blanks(); at_ < text_.size() && begins_name(text_[at_]); skip_blanks()) {
      const std::string_view name = take_name();
      if (made.find(name) != nullptr) {
        refuse(concat("has two ", name));
      }
      skip_blanks();
      need(take("="));
      skip_blanks();
      const std::string_view quote = text_.substr(at_, 1);
      need(take("\"") || take("'"));
      made.attributes.emplace_back(name, value_of(take_to(quote)));
    }
    return made.attributes;
  }

  /// Tabs and line ends become blanks, as XML demands (1.0, 3.3.3).
  std::string value_of(std::string_view text) {
    std::string value;
    for (std::size_t begin = text.find('&'); begin < text.size(); begin = text.find('&')) {
      const std::size_t end = text.find(';', begin);
      const std::string character =
          end < text.size() ? character_of(text.substr(begin + 1, end - begin - 1)) : "";
      need(!character.empty(), "has an unknown entity");
      value += concat(text.substr(0, begin), character);
      text.remove_prefix(end + 1);
    }
    value += text;
    std::replace_if(
        value.begin(), value.end(), [](char c) { return c == '\t' || c == '\r' || c == '\n'; },
        ' ');
    return std::string(without_blanks(value));
  }

  std::string_view text_;
  const std::string& path_;
  const char* fix_;
  std::size_t at_ = 0;
  std::vector<XmlNode*> open_;  ///< from the document inwards
  std::ptrdiff_t counted_ = 0;  ///< up to here, lines are counted
  std::size_t line_ = 1;
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
  return TreeReader(text, path, fix).read();
}

}  // namespace flashbvh::tool
