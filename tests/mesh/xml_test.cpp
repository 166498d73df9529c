// XML: trees of elements; what is malformed is refused at its line.
#include "text/xml.hpp"
#include "support/test.hpp"
#include "text/messages.hpp"

TEST_CASE("an XML's elements, attributes without entities, and text") {
  const std::string text =
      "\xEF\xBB\xBF<?xml version='1.0'?><!DOCTYPE a><!-- <b> --><a:a>\n<b c = ' &lt;&#x41;\t&#66; "
      "' "
      "d:e='>'/><f\n><![CDATA[<g>]]> h</f ></a:a>\n";
  const tool::XmlNode root = tool::read_xml(text, "file", "correct it");
  CHECK(root.name == "a:a");
  CHECK(root.text.empty());
  REQUIRE(root.inside.size() == 2);
  CHECK(root.inside[0].line == 2);
  CHECK(root.inside[0].attribute("c") == "<A B");
  CHECK(root.inside[0].attribute("d:e") == ">");
  CHECK(root.inside[0].find("e") == nullptr);
  CHECK(root.inside[1].text == "<g>");
}

TEST_CASE("what is no XML is refused") {
  std::string deep;
  for (int i = 0; i < 1001; ++i) {
    deep += "<a>";
  }
  const std::string end = "is damaged or cut off";
  const std::pair<std::string, std::string> texts[] = {
      {"", "has no element"},
      {"<!-- a -->", "has no element"},
      {"a<b/>", "has text outside of elements"},
      {"<a/><b/>", "has a second root <b>"},
      {"<a b='' b=''/>", "has two b"},
      {"<a b='&c;'/>", "has an unknown entity"},
      {"<a b='&#0;'/>", "has an unknown entity"},
      {"<a b='&lt'/>", "has an unknown entity"},
      {"<a>\n<b></a>", end + " in <'b'>"},
      {"<a", end},
      {"<a>", end + " in <'a'>"},
      {"<a></a", end + " in <'a'>"},
      {"</a>", end},
      {"<a><!-- b</a>", end + " in <'a'>"},
      {"<a><![CDATA[ b</a>", end + " in <'a'>"},
      {"<a b></a>", end},
      {"<a b=c></a>", end},
      {"<a b='c></a>", end},
      {"<a / ></a>", end},
      {"<a></ a>", end + " in <'a'>"},
      {"<a></a b>", end + " in <'a'>"},
      {"<a;/>", end},
      {"<a'b'/>", end},
      {"<a><1/></a>", end + " in <'a'>"},
      {"<?xml version=\"1?><a/>", end},
      {"<?xml version=1?><a/>", end},
      {"<!DOCTYPE a [<!ENTITY b 'c'>]><a/>", "has text outside of elements"},
      {"<a>1 < 2</a>", end + " in <'a'>"},
      {deep, "nests elements over 1000 deep"},
      {std::string("<a\0/>", 5), "is no text"}};
  for (const auto& [text, said] : texts) {
    CAPTURE(text);
    CHECK_THROWS_WITH(tool::read_xml(text, "file", "correct it"),
                      Catch::Matchers::StartsWith("file") && Catch::Matchers::Contains(said) &&
                              Catch::Matchers::EndsWith("; correct it") ||
                          Catch::Matchers::Contains("deep; write it again"));
  }
}
