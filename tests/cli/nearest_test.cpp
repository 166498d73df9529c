// Suggestions for mistyped words.
#include "text/nearest.hpp"

#include <map>
#include <string>

#include "support/test.hpp"

TEST_CASE("edits between words are the fewest, and the same both ways") {
  struct Row {
    const char *a, *b;
    std::size_t edits;
  };
  for (const Row& row :
       {Row{"", "", 0}, Row{"", "bake", 4}, Row{"bake", "bake", 0}, Row{"bak", "bake", 1},
        Row{"bakke", "bake", 1}, Row{"bale", "bake", 1}, Row{"bkae", "bake", 2},
        Row{"kitten", "sitting", 3}, Row{"saturday", "sunday", 3}, Row{"abc", "xyz", 3}}) {
    CAPTURE(row.a, row.b);
    CHECK(tool::edits_between(row.a, row.b) == row.edits);
    CHECK(tool::edits_between(row.b, row.a) == row.edits);
  }
}

TEST_CASE("the nearest word is named, and none if none is near") {
  const std::vector<std::string> words = {"bake", "inside", "info", "report", "o", "dry-run"};
  for (const auto& [word, nearest] : std::map<std::string, std::string>{{"bak", "bake"},
                                                                        {"info", "info"},
                                                                        {"inof", "info"},
                                                                        {"insid", "inside"},
                                                                        {"in", "inside"},
                                                                        {"dry", "dry-run"},
                                                                        {"reprot", "report"},
                                                                        {"o", "o"},
                                                                        {"p", ""},
                                                                        {"", ""},
                                                                        {"cook", ""},
                                                                        {"frobnicate", ""}}) {
    CAPTURE(word);
    CHECK(tool::nearest_word(word, words) == nearest);
  }
  CHECK(tool::nearest_word("bake", {}).empty());
  CHECK(tool::nearest_hint("bak", words) == "; the nearest is 'bake'");
  CHECK(tool::nearest_hint("dry", words, "--") == "; the nearest is '--dry-run'");
  CHECK(tool::nearest_hint("cook", words).empty());
}
