#include "robot/audit/srdf_text.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "robot/read/xml_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/xml_markup.hpp"

namespace flashbvh::tool {
namespace {

using NamePair = std::pair<std::string, std::string>;

/// A range of the text.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The ranges of the elements directly below the root, and of the root's end.
struct SrdfSpans {
  std::vector<Span> elements;
  Span root_end;  ///< "</robot>", or the "/>" of a root without content
};

/// For XML that TinyXML reads; TinyXML ignores everything after the root.
SrdfSpans spans_of(std::string_view text) {
  SrdfSpans spans;
  std::size_t depth = 0;
  std::size_t begin = 0;
  for (std::optional<Markup> found = next_markup(text, 0); found && spans.root_end.end == 0;
       found = next_markup(text, found->end)) {
    if (found->kind == Markup::Kind::other) {
      continue;
    }
    const bool closes = found->kind == Markup::Kind::end;
    const bool is_start = found->kind == Markup::Kind::start;
    begin = depth == 1 ? found->begin : begin;
    depth += is_start ? 1 : 0;
    depth -= closes && depth != 0 ? 1 : 0;
    if (depth == 1 && !is_start) {
      spans.elements.push_back({begin, found->end});
    } else if (depth == 0) {
      spans.root_end = {closes ? found->begin : found->end - 2, found->end};
    }
  }
  return spans;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

std::string xml_text(const std::string& name) {
  std::string text;
  for (const char c : name) {
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return text;
}

std::string element_text(const char* name, const NamePair& links) {
  return concat("<", name, " link1=\"", xml_text(links.first), "\" link2=\"",
                xml_text(links.second), "\"");
}

std::string disabling_text(const Model& model, const SrdfLine& line) {
  return concat(
      element_text("disable_collisions", {model.links[line.a].name, model.links[line.b].name}),
      " reason=\"", line.reason, "\"/>");
}

NamePair sorted(const std::string& a, const std::string& b) {
  return std::minmax(a, b);
}

class SrdfEditor {
 public:
  SrdfEditor(const std::string& path, const Model& model, const SrdfChanges& changes)
      : path_(path), model_(model), changes_(changes), text_(read_file(path)) {
    parse_xml(text_, path, "robot", document_);
    spans_ = spans_of(text_);
    elements_ = elements_in(*document_.RootElement());
    if (!std::equal(elements_.begin(), elements_.end(), spans_.elements.begin(),
                    spans_.elements.end(),
                    [&](const TiXmlElement* element, const Span& span) {
                      const std::string& name = element->ValueStr();
                      return text_.compare(span.begin + 1, name.size(), name) == 0;
                    }) ||
        spans_.root_end.end == 0) {
      refuse();
    }
    for (const SrdfLine& line : changes.disabled) {
      disabled_.insert(sorted(model.links[line.a].name, model.links[line.b].name));
    }
    for (const auto& [a, b] : changes.enabled) {
      enabled_.insert(sorted(model.links[a].name, model.links[b].name));
    }
    line_end_ = text_.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  }

  std::string change() {
    std::vector<Edit> edits = cuts();
    const std::size_t cut_count = edits.size();
    const std::vector<std::string> added = added_elements();
    if (!added.empty()) {
      edits.push_back(insertion(added));
    }
    // From the back, so that positions before an edit stay valid.
    std::sort(edits.begin(), edits.end(),
              [](const Edit& one, const Edit& other) { return one.span.begin > other.span.begin; });
    for (const Edit& edit : edits) {
      const Span span = edit.text.empty() ? whole_line(edit.span) : edit.span;
      text_.replace(span.begin, span.end - span.begin, edit.text);
    }
    TiXmlDocument after;
    parse_xml(text_, path_, "robot", after);
    if (elements_in(*after.RootElement()).size() != elements_.size() - cut_count + added.size()) {
      refuse();
    }
    return std::move(text_);
  }

 private:
  struct Edit {
    Span span;
    std::string text;  ///< the replacement
  };

  /// TinyXML accepts tags that are invalid XML.
  [[noreturn]] void refuse() const {
    throw UserError(path_, "has tags that are no sound XML, so it can't be changed; correct them");
  }

  static NamePair links_of(const TiXmlElement& element) {
    return sorted(attribute(&element, "link1"), attribute(&element, "link2"));
  }

  bool has(const char* kind, const std::string& link) const {
    return std::any_of(elements_.begin(), elements_.end(), [&](const TiXmlElement* e) {
      return e->ValueStr() == kind && attribute(e, "link") == link;
    });
  }

  bool is_enabled(const NamePair& links) const {
    return std::any_of(elements_.begin(), elements_.end(), [&](const TiXmlElement* e) {
      return e->ValueStr() == "enable_collisions" && links_of(*e) == links;
    });
  }

  std::vector<std::string> added_elements() const {
    std::vector<std::string> added;
    for (const SrdfLine& line : changes_.disabled) {
      added.push_back(disabling_text(model_, line));
    }
    for (const auto& [a, b] : changes_.enabled) {
      const NamePair links = {model_.links[a].name, model_.links[b].name};
      const bool is_default = has("disable_default_collisions", links.first) ||
                              has("disable_default_collisions", links.second);
      if (is_default && !is_enabled(sorted(links.first, links.second))) {
        added.push_back(element_text("enable_collisions", links) + "/>");
      }
    }
    return added;
  }

  std::size_t line_begin(std::size_t at) const {
    const std::size_t end = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
    return end == std::string::npos ? 0 : end + 1;
  }

  /// The blanks before an element on its line; two spaces if other text stands there.
  std::string indent_of(std::size_t element) const {
    if (element >= elements_.size()) {
      return "  ";
    }
    const std::size_t at = spans_.elements[element].begin;
    const std::string before = text_.substr(line_begin(at), at - line_begin(at));
    return is_blank(before) ? before : "  ";
  }

  /// Extends a range to its whole line if nothing else is on that line.
  Span whole_line(const Span& span) const {
    const std::string_view text = text_;
    const std::size_t begin = line_begin(span.begin);
    const std::size_t end = std::min(text.find('\n', span.end), text.size());
    return is_blank(text.substr(begin, span.begin - begin)) &&
                   is_blank(text.substr(span.end, end - span.end))
               ? Span{begin, std::min(end + 1, text.size())}
               : span;
  }

  /// True if an element contradicts the changes.
  bool is_cut(const TiXmlElement& element) const {
    return (element.ValueStr() == "disable_collisions" && enabled_.count(links_of(element)) != 0) ||
           (element.ValueStr() == "enable_collisions" && disabled_.count(links_of(element)) != 0);
  }

  std::vector<Edit> cuts() const {
    std::vector<Edit> cuts;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (is_cut(*elements_[i])) {
        cuts.push_back({spans_.elements[i], ""});
      }
    }
    return cuts;
  }

  /// After the last element that disables a pair and stays, or at the end.
  Edit insertion(const std::vector<std::string>& added) const {
    std::string indent = indent_of(0);
    std::size_t at = 0;
    for (std::size_t i = elements_.size(); i-- != 0;) {
      if (elements_[i]->ValueStr() == "disable_collisions") {
        indent = indent_of(i);
        at = at == 0 && !is_cut(*elements_[i]) ? behind_comment(spans_.elements[i].end) : at;
      }
    }
    std::string lines;
    for (const std::string& line : added) {
      lines += concat(line_end_, indent, line);
    }
    return at != 0 ? Edit{{at, at}, lines} : at_end(lines);
  }

  /// The position after a comment that follows on the line, or `at`.
  std::size_t behind_comment(std::size_t at) const {
    const std::size_t next = std::min(text_.find_first_not_of(" \t", at), text_.size());
    const std::size_t end =
        text_.compare(next, 4, "<!--") == 0 ? behind(text_, "-->", next + 4) : at;
    return text_.find('\n', at) < end ? at : end;
  }

  Edit at_end(const std::string& lines) const {
    const Span& end = spans_.root_end;
    if (text_.compare(end.begin, 2, "/>") == 0) {
      return {end, concat(">", lines, line_end_, "</robot>")};
    }
    const std::size_t begin = line_begin(end.begin);
    const bool is_alone =
        begin != 0 && is_blank(std::string_view(text_).substr(begin, end.begin - begin));
    const std::size_t before = begin > 1 && text_[begin - 2] == '\r' ? begin - 2 : begin - 1;
    const std::size_t at = is_alone ? before : end.begin;
    return {{at, at}, is_alone ? lines : lines + line_end_};
  }

  const std::string& path_;
  const Model& model_;
  const SrdfChanges& changes_;
  std::string text_;
  SrdfSpans spans_;
  TiXmlDocument document_;
  std::vector<TiXmlElement*> elements_;
  std::set<NamePair> enabled_;  ///< by the changes
  std::set<NamePair> disabled_;
  std::string line_end_;
};

}  // namespace

std::string srdf_of(const Model& model, const std::vector<SrdfLine>& lines) {
  std::string text =
      concat("<?xml version=\"1.0\"?>\n<robot name=\"", xml_text(model.name), "\">\n");
  for (const SrdfLine& line : lines) {
    text += concat("  ", disabling_text(model, line), "\n");
  }
  return text + "</robot>\n";
}

std::string changed_srdf(const std::string& path, const Model& model, const SrdfChanges& changes) {
  return SrdfEditor(path, model, changes).change();
}

}  // namespace flashbvh::tool
