#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "mesh/scene_checks.hpp"
#include "text/messages.hpp"
#include "text/xml_tags.hpp"

namespace flashbvh::tool {
namespace {

/// Elements that assimp leaves out, or reads as something else.
constexpr std::array<std::pair<std::string_view, const char*>, 6> kMisread = {
    {{"instance_controller", "a skin or a morph; export the pose as a mesh without it"},
     {"skew", "a transform; export it as a <matrix>"},
     {"trifans", "fans of triangles; export it as <triangles>"},
     {"convex_mesh", "a convex hull; export it as a <mesh>"},
     {"spline", "curves; export it as a <mesh>"},
     {"brep", "a model of CAD; export it as a <mesh>"}}};

constexpr std::array<std::string_view, 3> kReferences = {"instance_geometry", "instance_node",
                                                         "instance_visual_scene"};
constexpr std::array<std::string_view, 3> kTargets = {"geometry", "node", "visual_scene"};
constexpr std::array<std::string_view, 4> kPolygons = {"triangles", "polylist", "polygons",
                                                       "tristrips"};

template <class Names>
bool is_one_of(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void check_collada(std::string_view text, const std::string& file) {
  std::set<std::string, std::less<>> ids;
  std::set<std::string> references;
  std::string unit;
  XmlTags tags(text, file);
  while (const std::optional<XmlTag> tag = tags.next()) {
    const auto text_of = [&](const char* name) {
      return std::string(tag->attribute(name).value_or(""));
    };
    for (const auto& [name, what] : kMisread) {
      if (tag->name == name) {
        throw UserError(file, "has a <", tag->name, ">, ", what);
      }
    }
    if (is_one_of(kTargets, tag->name)) {
      ids.insert(text_of("id"));
    } else if (is_one_of(kReferences, tag->name)) {
      references.insert(text_of("url"));
    } else if (is_one_of(kPolygons, tag->name) && text_of("count").empty()) {
      throw UserError(file, "can't be read: has <", tag->name,
                      "> without a count; export the mesh again");
    } else if (tag->name == "p" && tag->text.find('-') != std::string_view::npos) {
      throw UserError(file,
                      "can't be read: has a <p> with a negative index; export the mesh again");
    } else if (tag->name == "unit") {
      const std::string metres = std::string(tag->attribute("meter").value_or("1"));
      if (!(parse_number(metres).value_or(0) > 0) || (!unit.empty() && unit != metres)) {
        throw UserError(file, "has a <unit> of ", tool::quoted(metres), " metres",
                        unit.empty() ? "" : " beside another", "; give one positive number");
      }
      unit = metres;
    }
  }
  for (const std::string& reference : references) {
    if (reference.empty() || reference[0] != '#' || ids.count(reference.substr(1)) == 0) {
      throw UserError(file, "refers to ", tool::quoted(reference),
                      ", which is not in the file; export it as one file");
    }
  }
}

}  // namespace flashbvh::tool
