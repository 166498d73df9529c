#include "text/xml_tags.hpp"

#include <utility>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kXmlBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kXmlBlanks);
  return begin == std::string_view::npos
             ? std::string_view()
             : text.substr(begin, text.find_last_not_of(kXmlBlanks) + 1 - begin);
}

/// Takes NAME="VALUE" from the front; an empty name if there is none.
std::pair<std::string_view, std::string_view> take_attribute(std::string_view& rest) {
  const std::size_t equals = rest.find('=');
  const std::size_t quote = rest.find_first_of("\"'", equals);
  if (equals == std::string_view::npos || quote == std::string_view::npos) {
    return {};
  }
  const std::size_t end = rest.find(rest[quote], quote + 1);
  if (end == std::string_view::npos) {
    return {};
  }
  const std::pair<std::string_view, std::string_view> taken = {
      trimmed(rest.substr(0, equals)), rest.substr(quote + 1, end - quote - 1)};
  rest.remove_prefix(end + 1);
  return taken;
}

}  // namespace

std::string_view local_name(std::string_view name) {
  return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

std::optional<std::string_view> XmlTag::attribute(std::string_view wanted) const {
  std::string_view rest = attributes;
  for (auto taken = take_attribute(rest); !taken.first.empty(); taken = take_attribute(rest)) {
    const std::string_view key = taken.first;
    if (key == wanted || (wanted[0] == ':' && key.size() > wanted.size() &&
                          key.substr(key.size() - wanted.size()) == wanted)) {
      return taken.second;
    }
  }
  return std::nullopt;
}

std::optional<XmlTag> XmlTags::next() {
  if (is_in_last_) {
    open_.pop_back();
    is_in_last_ = false;
  }
  while (const std::optional<Markup> found = next_markup(text_, at_)) {
    const bool is_closed = text_[found->end - 1] == '>';
    std::string_view inside = text_.substr(found->begin + 1, found->end - found->begin - 2);
    at_ = found->end;
    if (found->kind == Markup::Kind::other) {
      continue;
    }
    if (!is_closed) {
      refuse();
    }
    if (found->kind == Markup::Kind::end) {
      if (open_.empty() || trimmed(inside.substr(1)) != open_.back()) {
        refuse();
      }
      open_.pop_back();
      continue;
    }
    if (found->kind == Markup::Kind::empty) {
      inside.remove_suffix(1);
    }
    const std::string_view name = inside.substr(0, inside.find_first_of(kXmlBlanks));
    open_.push_back(name);
    is_in_last_ = found->kind == Markup::Kind::empty;
    const std::size_t text_end = is_in_last_ ? at_ : text_.find('<', at_);
    return XmlTag{name, inside.substr(name.size()), trimmed(text_.substr(at_, text_end - at_))};
  }
  if (!open_.empty()) {
    refuse();
  }
  return std::nullopt;
}

std::string_view XmlTags::parent() const {
  return open_.size() < 2 ? std::string_view() : local_name(open_[open_.size() - 2]);
}

void XmlTags::refuse() const {
  throw UserError(place_, "can't be read: is damaged or cut off",
                  open_.empty() ? "" : concat(" in <", tool::quoted(open_.back()), ">"),
                  "; export the mesh again");
}

}  // namespace flashbvh::tool
