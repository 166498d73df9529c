// The levels of an XML text are TinyXML's, so that no text makes TinyXML recurse deeper than
// allowed.
#include "text/xml_markup.hpp"

#include <tinyxml.h>

#include <iterator>
#include <string>

#include "support/random.hpp"
#include "support/test.hpp"

namespace {

std::size_t levels_below(const TiXmlNode& node) {
  std::size_t most = 0;
  for (const TiXmlNode* child = node.FirstChild(); child != nullptr; child = child->NextSibling()) {
    most = std::max(most, levels_below(*child) + (child->ToElement() != nullptr ? 1 : 0));
  }
  return most;
}

/// The levels by TinyXML itself.
struct ByTinyXml {
  std::size_t levels;
  bool is_sound;
};
ByTinyXml by_tinyxml(std::string text) {
  text.append(4, '\0');  // TinyXML reads a character beyond the end
  TiXmlDocument document;
  document.Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  return {levels_below(document), !document.Error()};
}

constexpr const char* kParts[] = {
    "<a>",  "<a>",    "</a>",     "</a>", "<a/>", "<b c='",    "<b c=\"", "'>",
    "\">",  "'/>",    "<!--",     "-->",  "<!",   "<![CDATA[", "]]>",     "<?xml ",
    "<?",   "?>",     "version=", "\"",   "'",    ">",         "/>",      "/",
    " ",    "=",      "x",        "<",    "\xC3", "\xE0",      "\xF0",    "\xEF\xBB\xBF",
    "\xEF", "&#x41;", "&#",       ";",    "&lt;", "\x7F",      "d=e",     "</a >",
    "\n"};

std::string any_text(Random& random) {
  std::string text;
  for (std::int32_t parts = random.between(1, 14); parts != 0; --parts) {
    text += kParts[random.below(std::size(kParts))];
  }
  return random.below(2) == 0 ? text : "<a>" + text + "</a>";
}

}  // namespace

TEST_CASE("levels of texts in which tags hide") {
  const auto [text, levels] = GENERATE(table<std::string, std::size_t>({
      {"", 0},
      {"text", 0},
      {"<a/>", 1},
      {"<a><b/></a><a/>", 2},
      {"<a c='/>'><b/></a>", 2},
      {"<a c=\"'>\"><b/></a>", 2},
      {"<a><!-- </a> <x --><b/></a>", 2},
      {"<a><!--><b><c><d>--></a>", 1},
      {"<a><![CDATA[ </a><b>\xC3]]><b/></a>", 2},
      {"<?xml version='><!--'?><a/><!--->", 1},
      {"<?other '>'?><a/>", 0},
      {"<a c=\"\xC3\"/>\"><b/></a>", 2},
      {"<a>\xC3</a><b/></a>", 2},
  }));
  CAPTURE(text);
  CHECK(by_tinyxml(text).levels == levels);
  CHECK(tool::levels_of(text) == levels);
}

TEST_CASE("levels of any texts are TinyXML's") {
  Random random(test_seed());
  int sound = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string text = any_text(random);
    CAPTURE(text);
    const ByTinyXml made = by_tinyxml(text);
    const std::size_t levels = tool::levels_of(text);
    REQUIRE(levels >= made.levels);
    REQUIRE((levels == made.levels || !made.is_sound));
    sound += made.is_sound && made.levels > 1 ? 1 : 0;
  }
  CHECK(sound > 100);
}
