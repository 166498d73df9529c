#include <map>
#include <set>

#include "mesh/limited_import.hpp"
#include "mesh/scene_checks.hpp"
#include "text/messages.hpp"
#include "text/xml.hpp"

namespace flashbvh::tool {
namespace {

/// Elements that assimp leaves out, or reads as something else.
const std::map<std::string_view, const char*> kMisread = {
    {"instance_controller", "a skin or a morph; export the pose as a mesh without it"},
    {"skew", "a transform; export it as a <matrix>"},
    {"trifans", "fans of triangles; export it as <triangles>"},
    {"convex_mesh", "a convex hull; export it as a <mesh>"},
    {"spline", "curves; export it as a <mesh>"},
    {"brep", "a model of CAD; export it as a <mesh>"}};

using Names = std::set<std::string, std::less<>>;
const Names kReferences = {"instance_geometry", "instance_node", "instance_visual_scene"};
const Names kTargets = {"geometry", "node", "visual_scene"};
const Names kPolygons = {"triangles", "polylist", "polygons", "tristrips"};

struct ColladaChecks {
  const std::string& file;
  Names ids;
  Names references;
  std::string unit;

  void check(const XmlNode& element) {
    const std::string_view name = element.name;
    if (const auto misread = kMisread.find(name); misread != kMisread.end()) {
      throw UserError(file, "has a <", name, ">, ", misread->second);
    }
    if (kTargets.count(name) != 0) {
      ids.insert(element.attribute("id"));
    } else if (kReferences.count(name) != 0) {
      references.insert(element.attribute("url"));
    } else if (kPolygons.count(name) != 0 && element.attribute("count").empty()) {
      throw UserError(file, "can't be read: has <", name, "> without a count", kImportFix);
    } else if (name == "p" && element.text.find('-') < element.text.size()) {
      throw UserError(file, "can't be read: has a <p> with a negative index", kImportFix);
    } else if (name == "unit") {
      check_unit(element.find("meter") == nullptr ? "1" : element.attribute("meter"));
    }
    for (const XmlNode& inside : element.inside) {
      check(inside);
    }
  }

  void check_unit(const std::string& metres) {
    if (!(parse_number(metres).value_or(0) > 0) || (!unit.empty() && unit != metres)) {
      throw UserError(file, "has a <unit> of ", quoted(metres), " metres",
                      unit.empty() ? "" : " beside another", "; give one positive number");
    }
    unit = metres;
  }
};

}  // namespace

void check_collada(std::string_view text, const std::string& file) {
  ColladaChecks checks = {file, {}, {}, {}};
  checks.check(read_xml(text, file, "export the mesh again"));
  for (const std::string& reference : checks.references) {
    if (reference.empty() || reference[0] != '#' || checks.ids.count(reference.substr(1)) == 0) {
      throw UserError(file, "refers to ", quoted(reference),
                      ", which is not in the file; export it as one file");
    }
  }
}

}  // namespace flashbvh::tool
