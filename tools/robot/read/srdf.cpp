#include "robot/read/urdf.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

class SrdfReader {
 public:
  SrdfReader(const std::string& path, const Model& model, const std::vector<std::string>& all_links,
             Warnings& warnings)
      : path_(path), model_(model), all_links_(all_links), warnings_(warnings) {}

  std::vector<DisabledPair> read(const TiXmlElement& robot) {
    for_each(robot, "enable_collisions", [&](const TiXmlElement& e) {
      if (const auto pair = pair_of(e)) {
        enabled_.insert(*pair);
      }
    });
    for_each(robot, "disable_collisions", [&](const TiXmlElement& e) {
      const auto pair = pair_of(e);
      if (pair && enabled_.count(*pair) != 0) {
        warnings_.add(place_of(e), concat("disables ", model_.links[pair->first].name, " - ",
                                          model_.links[pair->second].name,
                                          ", which is enabled as well; it counts as disabled"));
      }
      if (pair) {
        disable(*pair, attribute(&e, "reason"), e);
      }
    });
    for_each(robot, "disable_default_collisions",
             [&](const TiXmlElement& e) { disable_all_of(e); });
    return std::move(disabled_);
  }

 private:
  template <class Visit>
  static void for_each(const TiXmlElement& robot, const char* name, const Visit& visit) {
    for (const TiXmlElement* e = robot.FirstChildElement(name); e != nullptr;
         e = e->NextSiblingElement(name)) {
      visit(*e);
    }
  }

  static std::size_t line_of(const TiXmlElement& element) {
    return static_cast<std::size_t>(element.Row());
  }
  std::string place_of(const TiXmlElement& element) const {
    return at_line(path_, line_of(element));
  }

  /// A link's number, or the number of links if it has no geometry. UserError if it has no name.
  std::size_t link_of(const TiXmlElement& element, const char* which) {
    const std::string name = attribute(&element, which);
    if (name.empty()) {
      throw UserError(place_of(element), "has a <", element.Value(), "> that does not name ",
                      std::string(which) == "link" ? "a link; give it link"
                                                   : "two links; give it link1 and link2");
    }
    if (std::find(all_links_.begin(), all_links_.end(), name) == all_links_.end()) {
      warnings_.add(place_of(element), concat("names ", tool::quoted(name),
                                              ", which is no link of the robot; left out"));
    }
    const auto found = std::find_if(model_.links.begin(), model_.links.end(),
                                    [&](const ModelLink& link) { return link.name == name; });
    return static_cast<std::size_t>(found - model_.links.begin());
  }

  /// The numbers of two links with geometry, the lower first.
  std::optional<Pair> pair_of(const TiXmlElement& element) {
    const std::size_t one = link_of(element, "link1");
    const std::size_t other = link_of(element, "link2");
    const auto [a, b] = std::minmax(one, other);
    return b < model_.links.size() && a != b ? std::optional<Pair>({a, b}) : std::nullopt;
  }

  void disable(const Pair& pair, const std::string& reason, const TiXmlElement& element) {
    if (known_.insert(pair).second) {
      disabled_.push_back({pair.first, pair.second, reason, line_of(element)});
    }
  }

  void disable_all_of(const TiXmlElement& element) {
    const std::size_t link = link_of(element, "link");
    for (std::size_t other = 0; other < model_.links.size(); ++other) {
      const Pair pair = std::minmax(link, other);
      if (link < model_.links.size() && other != link && enabled_.count(pair) == 0) {
        disable(pair, element.Value(), element);
      }
    }
  }

  const std::string& path_;
  const Model& model_;
  const std::vector<std::string>& all_links_;
  Warnings& warnings_;
  std::set<Pair> enabled_;
  std::set<Pair> known_;
  std::vector<DisabledPair> disabled_;
};

}  // namespace

std::vector<DisabledPair> read_srdf(const std::string& path, const Model& model,
                                    const std::vector<std::string>& all_links, Warnings& warnings) {
  TiXmlDocument document;
  read_xml(path, "robot", document);
  const TiXmlElement& robot = *document.RootElement();
  if (attribute(&robot, "name") != model.name) {
    warnings.add(path, concat("is of a robot ", tool::quoted(attribute(&robot, "name")),
                              ", not of ", tool::quoted(model.name)));
  }
  return SrdfReader(path, model, all_links, warnings).read(robot);
}

}  // namespace flashbvh::tool
