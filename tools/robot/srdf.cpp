#include "robot/srdf.hpp"

#include <algorithm>
#include <set>

#include "robot/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Its number, or the number of links if it has no geometry.
std::size_t link_of(const Model& model, const std::string& name) {
  const auto found = std::find_if(model.links.begin(), model.links.end(),
                                  [&](const ModelLink& link) { return link.name == name; });
  return static_cast<std::size_t>(found - model.links.begin());
}

/// Two names; UserError if one is missing.
std::array<std::string, 2> names_in(const TiXmlElement& element, const std::string& path) {
  std::array<std::string, 2> names = {attribute(&element, "link1"), attribute(&element, "link2")};
  if (names[0].empty() || names[1].empty()) {
    throw UserError(at_line(path, static_cast<std::size_t>(element.Row())),
                    "has a <disable_collisions> that does not name two links; give it link1 and "
                    "link2");
  }
  return names;
}

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
  if (robot.FirstChildElement("disable_default_collisions") != nullptr) {
    warnings.add(path, "has <disable_default_collisions>, which does not count; name the pairs");
  }
  std::vector<DisabledPair> disabled;
  std::set<std::pair<std::size_t, std::size_t>> known;
  for (const TiXmlElement* e = robot.FirstChildElement("disable_collisions"); e != nullptr;
       e = e->NextSiblingElement("disable_collisions")) {
    const std::array<std::string, 2> names = names_in(*e, path);
    for (const std::string& name : names) {
      if (std::find(all_links.begin(), all_links.end(), name) == all_links.end()) {
        warnings.add(
            at_line(path, static_cast<std::size_t>(e->Row())),
            concat("names ", tool::quoted(name), ", which is no link of the robot; left out"));
      }
    }
    const auto [a, b] = std::minmax({link_of(model, names[0]), link_of(model, names[1])});
    if (b < model.links.size() && a != b && known.emplace(a, b).second) {
      disabled.push_back({a, b, attribute(e, "reason")});
    }
  }
  return disabled;
}

}  // namespace flashbvh::tool
