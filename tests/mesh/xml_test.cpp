// XML: trees of elements; what is malformed is refused at its line.
#include "text/xml.hpp"
#include "support/test.hpp"
#include "text/messages.hpp"

TEST_CASE("an XML's elements, attributes without entities, and text") {
  const std::string text =
      "\xEF\xBB\xBF<?xml version='1.0'?><!DOCTYPE a><!-- <b> --><a:a>\n<b c = ' &lt;&#x41;\t&#66; "
      "' "
      "d:e='>'/><f\n> <![CDATA[<g>]]> h&#xE9;\n<!-- -->&amp;\n</f ></a:a>\n";
  const tool::XmlNode root = tool::read_xml(text, "file", "correct it");
  CHECK(root.name == "a:a");
  CHECK(root.text.empty());
  REQUIRE(root.inside.size() == 2);
  CHECK(root.inside[0].line == 2);
  CHECK(root.inside[0].attribute("c") == "<A B");
  CHECK(root.inside[0].attribute("d:e") == ">");
  CHECK(root.inside[0].find("e") == nullptr);
  CHECK(root.inside[1].text == "<g> h\xC3\xA9\n&");
}

TEST_CASE("what is no XML is refused") {
  std::string deep;
  for (int i = 0; i < 1001; ++i) {
    deep += "<a>";
  }
  const std::string end = "no element found";
  const std::string wrong = "not well-formed (invalid token)";
  const std::pair<std::string, std::string> texts[] = {
      {"", end},
      {"a", "syntax error"},
      {"a<b/>", wrong},
      {"<a b='&c;'/>", "undefined entity"},
      {"<!DOCTYPE a><a>&c;</a>", "undefined entity in <'a'>"},
      {"<a>\n<b></a>", "mismatched tag in <'b'>"},
      {"<a", "unclosed token"},
      {"<a>", end + " in <'a'>"},
      {"<a><!-- b</a>", "unclosed token in <'a'>"},
      {"<?xml version=\"1?><a/>", "XML declaration not well-formed"},
      {"<?xml version='1.0' encoding='KOI8-R'?><a/>", "unknown encoding"},
      {"<!DOCTYPE a [<!ENTITY b 'c'>]><a/>", "has a <!DOCTYPE> with declarations"},
      {"<!DOCTYPE a SYSTEM 'b.dtd'><a>&c;</a>", "has a <!DOCTYPE> with 'b.dtd'"},
      {deep, "nests elements over 1000 deep"},
      {std::string("<a\0/>", 5), "is no text"}};
  for (const auto& [text, said] : texts) {
    CAPTURE(text);
    CHECK_THROWS_WITH(
        tool::read_xml(text, "file", "correct it"),
        Catch::Matchers::StartsWith("file") && Catch::Matchers::Contains(said) &&
            Catch::Matchers::EndsWith(said.find("deep") < said.size() ? "; write it again"
                                      : said.find("<!") < said.size() ? "; write it without"
                                                                      : "; correct it"));
  }
}
