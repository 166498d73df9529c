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
  SrdfReader(const std::string& path, const Model& model, Warnings& warnings)
      : path_(path), model_(model), warnings_(warnings) {}

  std::vector<DisabledPair> read(const XmlNode& robot) {
    for (const XmlNode* e : elements_in(robot, "enable_collisions")) {
      if (const auto pair = pair_of(*e)) {
        enabled_.insert(*pair);
      }
    }
    for (const XmlNode* e : elements_in(robot, "disable_collisions")) {
      const auto pair = pair_of(*e);
      if (pair && enabled_.count(*pair) != 0) {
        warnings_.add(place_of(*e), concat("disables ", model_.links[pair->first].name, " - ",
                                           model_.links[pair->second].name,
                                           ", which is enabled as well; it counts as disabled"));
      }
      if (pair) {
        disable(*pair, attribute(e, "reason"), *e);
      }
    }
    for (const XmlNode* e : elements_in(robot, "disable_default_collisions")) {
      disable_all_of(*e);
    }
    return std::move(disabled_);
  }

 private:
  std::string place_of(const XmlNode& element) const { return at_line(path_, element.line); }

  /// A link's number, or kNoLink if it has no geometry. UserError if it has no name.
  std::size_t link_of(const XmlNode& element, const char* which) {
    const std::string name = attribute(&element, which);
    if (name.empty()) {
      throw UserError(place_of(element), "has a <", element.name, "> that does not name ",
                      std::string(which) == "link" ? "a link; give it link"
                                                   : "two links; give it link1 and link2");
    }
    if (std::none_of(model_.mounts.begin(), model_.mounts.end(),
                     [&](const ModelMount& link) { return link.name == name; })) {
      warnings_.add(place_of(element), concat("names ", tool::quoted(name),
                                              ", which is no link of the robot; left out"));
    }
    return find_link(model_, name);
  }

  /// The numbers of two links with geometry, the lower first.
  std::optional<Pair> pair_of(const XmlNode& element) {
    const std::size_t one = link_of(element, "link1");
    const std::size_t other = link_of(element, "link2");
    const auto [a, b] = std::minmax(one, other);
    return b != kNoLink && a != b ? std::optional<Pair>({a, b}) : std::nullopt;
  }

  void disable(const Pair& pair, const std::string& reason, const XmlNode& element) {
    if (known_.insert(pair).second) {
      disabled_.push_back({pair.first, pair.second, reason, element.line});
    }
  }

  void disable_all_of(const XmlNode& element) {
    const std::size_t link = link_of(element, "link");
    for (std::size_t other = 0; other < model_.links.size(); ++other) {
      const Pair pair = std::minmax(link, other);
      if (link != kNoLink && other != link && enabled_.count(pair) == 0) {
        disable(pair, std::string(element.name), element);
      }
    }
  }

  const std::string& path_;
  const Model& model_;
  Warnings& warnings_;
  std::set<Pair> enabled_;
  std::set<Pair> known_;
  std::vector<DisabledPair> disabled_;
};

}  // namespace

std::vector<DisabledPair> read_srdf(const std::string& path, const Model& model,
                                    Warnings& warnings) {
  const XmlNode robot = robot_xml(path);
  if (first_in(robot, "link") != nullptr) {
    throw UserError(path, "is a URDF; name the SRDF, which has <disable_collisions>");
  }
  if (attribute(&robot, "name") != model.name) {
    warnings.add(path, concat("is of a robot ", tool::quoted(attribute(&robot, "name")),
                              ", not of ", tool::quoted(model.name)));
  }
  return SrdfReader(path, model, warnings).read(robot);
}

}  // namespace flashbvh::tool
