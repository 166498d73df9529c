// An SRDF's text after changes: only the named pairs change.
#include "robot/audit/srdf_text.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "robot/read/urdf.hpp"
#include "support/arms/robot_files.hpp"
#include "support/test.hpp"
#include "text/files.hpp"

namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

/// Links a to d; XML escapes d's name.
tool::Model four_links(RobotFiles& files) {
  return files.read(link_texts("abc") + link_text("d &lt;&amp;&quot;") +
                    joint_text("j", "fixed", "a", "b") + joint_text("k", "fixed", "a", "c") +
                    joint_text("l", "fixed", "a", "d &lt;&amp;&quot;"));
}

std::string changed(RobotFiles& files, const tool::Model& model, const std::string& srdf,
                    const tool::SrdfChanges& changes) {
  files.write("x.srdf", srdf);
  return tool::changed_srdf(files.path("x.srdf"), model, changes);
}

const std::string kBegin = "<robot name=\"arm\">";
const std::string kEnd = "</robot>\n";

/// The text between kBegin and kEnd.
std::string changed_inside(RobotFiles& files, const tool::Model& model, const std::string& inside,
                           const tool::SrdfChanges& changes) {
  const std::string text = changed(files, model, kBegin + inside + kEnd, changes);
  REQUIRE(text.size() >= kBegin.size() + kEnd.size());
  const std::size_t size = text.size() - kBegin.size() - kEnd.size();
  REQUIRE(text == kBegin + text.substr(kBegin.size(), size) + kEnd);
  return text.substr(kBegin.size(), size);
}

Pairs disabled_in(RobotFiles& files, const tool::Model& model, const std::string& srdf) {
  files.write("y.srdf", srdf);
  Pairs pairs;
  for (const tool::DisabledPair& pair :
       tool::read_srdf(files.path("y.srdf"), model, files.warnings)) {
    pairs.emplace(pair.a, pair.b);
  }
  return pairs;
}

const std::string kLine = "<disable_collisions link1=\"a\" link2=\"b\" reason=\"Never\"/>";

}  // namespace

TEST_CASE("lines go and come where an SRDF has them") {
  RobotFiles files;
  const tool::Model model = four_links(files);
  const auto with = [&](const std::string& inside, const tool::SrdfChanges& changes) {
    return changed_inside(files, model, inside, changes);
  };
  const tool::SrdfChanges out = {{{0, 1}}, {}};
  const tool::SrdfChanges in = {{}, {{0, 2, "Never"}}};
  const std::string added = "<disable_collisions link1=\"a\" link2=\"c\" reason=\"Never\"/>";
  const std::string other = "<disable_collisions link2='c' link1='b'></disable_collisions>";

  CHECK(with("\n  " + kLine + "\n", out) == "\n");
  CHECK(with(kLine + other, out) == other);
  CHECK(with("\r\n\t" + kLine + " " + kLine + "\r\n", out) == "\r\n");
  CHECK(with("\n" + kLine + " <!-- why -->\n", out) == "\n <!-- why -->\n");
  CHECK(changed(files, model, "<robot name=\"arm\"/>", in) ==
        kBegin + "\n  " + added + "\n</robot>");
  CHECK(with("", in) == "\n  " + added + "\n");
  CHECK(with("\r\n<x/>\r\n", in) == "\r\n<x/>\r\n" + added + "\r\n");
  CHECK(with("\n\t" + other + " <!-- why --><x/>\n", in) ==
        "\n\t" + other + " <!-- why -->\n\t" + added + "<x/>\n");
  CHECK(with("\n" + other + "\n <!-- two\nlines --> ", in) ==
        "\n" + other + "\n" + added + "\n <!-- two\nlines --> ");
  CHECK(with("\n" + kLine + "\n", {{{0, 1}}, {{0, 2, "Never"}}}) == "\n" + added + "\n");
}

TEST_CASE("a pair that a default disables is enabled, and one that is enabled is not") {
  RobotFiles files;
  const tool::Model model = four_links(files);
  const std::string by_default = "\n<disable_default_collisions link=\"a\"/>\n";
  const std::string enabled = "<enable_collisions link1=\"a\" link2=\"b\"/>\n";
  const tool::SrdfChanges out = {{{0, 1}}, {}};
  CHECK(changed_inside(files, model, by_default, out) == by_default + enabled);
  CHECK(changed_inside(files, model, by_default + kLine + enabled, out) == by_default + enabled);
  CHECK(changed_inside(files, model, by_default + enabled, {{}, {{0, 1, "Never"}}}) ==
        by_default + kLine + "\n");
}

TEST_CASE("an SRDF whose root is not alone, or that is none") {
  RobotFiles files;
  const tool::Model model = four_links(files);
  CHECK(disabled_in(files, model, tool::srdf_of(model, {{0, 3, "Never"}, {1, 2, "Adjacent"}})) ==
        Pairs{{0, 3}, {1, 2}});
  CHECK(changed(files, model, "<!-- <robot> --><robot name=\"arm\">" + kLine + "</robot><!-- > -->",
                {{{0, 1}}, {}}) == "<!-- <robot> --><robot name=\"arm\"></robot><!-- > -->");
  files.write("x.srdf", "<robot name=\"arm\"><group></robot>");
  CHECK(refusal_of([&] {
          return tool::changed_srdf(files.path("x.srdf"), model, {});
        }).find("is no XML") != std::string::npos);
}

namespace {

/// A piece of an SRDF, and the pair that it disables.
struct Piece {
  std::string text;
  std::optional<std::pair<std::size_t, std::size_t>> pair;
};

Piece any_piece(Random& random) {
  const std::vector<std::string> others = {
      "<!-- <disable_collisions link1=\"a\" link2=\"b\"/> -->",
      "<group name='>'/>",
      "\n",
      "\r\n",
      "  ",
      "<group_state name=\"a/\"><joint name=\"j\" value='0'/></group_state>",
      "<passive_joint name=\"/>\"/>",
      "<g><disable_collisions link1=\"c\" link2=\"b\"/></g>",
      "<![CDATA[</robot>]]>",
      "<?say </robot>?>"};
  const std::vector<std::string> names = {"a", "b", "c", "d &lt;&amp;&quot;"};
  if (random.below(2) == 0) {
    return {others[random.below(static_cast<std::uint32_t>(others.size()))], {}};
  }
  const std::uint32_t a = random.below(3);
  const std::uint32_t b = a + 1 + random.below(3 - a);
  const bool is_turned = random.below(2) == 0;
  return {"<disable_collisions link1=\"" + names[is_turned ? b : a] + "\" link2=\"" +
              names[is_turned ? a : b] +
              (random.below(2) == 0 ? "\" reason=\"x\" />" : "\" ></disable_collisions>"),
          std::pair(a, b)};
}

std::string without_blanks(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](char c) { return c == ' ' || c == '\n' || c == '\r'; }),
             text.end());
  return text;
}

/// The text without the elements that a change adds.
std::string without_added(std::string text) {
  const std::string end = "reason=\"Never\"/>";
  for (std::size_t at = 0; (at = text.find(end)) != std::string::npos;) {
    const std::size_t begin = text.rfind('<', at);
    text.erase(begin, at + end.size() - begin);
  }
  return text;
}

}  // namespace

TEST_CASE("random SRDFs keep all that is not changed") {
  RobotFiles files;
  const tool::Model model = four_links(files);
  for_rounds(3000, [&](Random& random, int) {
    std::vector<Piece> pieces(random.below(12));
    Pairs before;
    for (Piece& piece : pieces) {
      piece = any_piece(random);
      if (piece.pair) {
        before.insert(*piece.pair);
      }
    }
    tool::SrdfChanges changes;
    Pairs after;
    for (const auto& pair : Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}) {
      const bool was = before.count(pair) != 0;
      const bool is = random.below(3) == 0 ? !was : was;
      if (is) {
        after.insert(pair);
      }
      if (was && !is) {
        changes.enabled.push_back(pair);
      } else if (is && !was) {
        changes.disabled.push_back({pair.first, pair.second, "Never"});
      }
    }
    std::string srdf = "<?xml version=\"1.0\"?>\n" + kBegin;
    std::string kept = srdf;
    for (const Piece& piece : pieces) {
      srdf += piece.text;
      kept += piece.pair && after.count(*piece.pair) == 0 ? "" : piece.text;
    }
    CAPTURE(srdf);
    const std::string text = changed(files, model, srdf + kEnd, changes);
    CHECK(disabled_in(files, model, text) == after);
    CHECK(without_blanks(without_added(text)) == without_blanks(kept + "</robot>"));
    if (changes.enabled.empty() && changes.disabled.empty()) {
      CHECK(text == srdf + kEnd);
    }
  });
}
